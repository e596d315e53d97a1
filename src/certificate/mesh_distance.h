#pragma once

#include <memory>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! A point of a mesh and the way out there.
struct NearestPoint
{
    Point3 point;
    Vec3 normal; //!< of its face, unit
};

//! Distance of points to the nearest point of a mesh, exact but for the rounding of doubles. May be asked
//! from several threads at once. Holds a copy of the corners.
class MeshDistance
{
public:
    //! Cost: O(n log n), about 0.4 s for a million faces. \throw UsageError where the mesh has no face
    //! with area; others are left out.
    explicit MeshDistance(const TriangleMesh& mesh);
    ~MeshDistance();
    MeshDistance(const MeshDistance&) = delete;
    MeshDistance& operator=(const MeshDistance&) = delete;

    //! Cost: O(log n) where the point is near the mesh.
    [[nodiscard]] double operator()(const Point3& p) const;

    //! The point of the mesh nearest to `p`; on a side of several faces the normal is that of one of them.
    [[nodiscard]] NearestPoint nearest(const Point3& p) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

} // namespace voroprobe
