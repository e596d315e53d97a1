#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "oracles/surface_oracle.h"
#include "support/random.h"

namespace voroprobe
{

//! Distance of a point to the nearest face of a mesh, by an AABB tree. \pre the mesh has a face.
class DistanceToMesh
{
public:
    explicit DistanceToMesh(const TriangleMesh& mesh);
    ~DistanceToMesh();
    DistanceToMesh(const DistanceToMesh&) = delete;
    DistanceToMesh& operator=(const DistanceToMesh&) = delete;

    [[nodiscard]] double operator()(const Point3& p) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

//! A point of a face and the face's unit normal.
struct FaceSample
{
    Point3 point;
    Vec3 normal;
};

//! Points spread over every face: its corners, and those that cut its sides into `intervals` >= 1 equal
//! parts, and the lattice between them. (intervals + 1)(intervals + 2) / 2 per face.
std::vector<FaceSample> sample_faces(const TriangleMesh& mesh, int intervals);

//! Largest |distance(p)| over the sampled faces. `distance`: signed or unsigned distance to the true surface.
double largest_distance_from_faces(const TriangleMesh& mesh,
                                   const std::function<double(const Point3&)>& distance, int intervals);

//! As above against any oracle: from each sample along the normal, both ways, to the nearest crossing. An
//! upper bound of the distance to the surface, for the nearest point need not lie on the normal; infinite
//! where there is no crossing within `reach`.
double largest_distance_from_faces(const TriangleMesh& mesh, const SurfaceOracle& oracle, double reach,
                                   int intervals);

//! Crossings of random long segments with the surface, at least `count`.
//! \pre the oracle has a surface.
std::vector<Point3> sample_surface(const SurfaceOracle& oracle, std::size_t count, Random& random);

//! Largest distance of the points to the mesh; infinite for a mesh without faces.
double largest_distance_from_points(const std::vector<Point3>& points, const TriangleMesh& mesh);

} // namespace voroprobe
