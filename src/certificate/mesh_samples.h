#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "support/random.h"

namespace voroprobe
{

//! A point of a mesh.
struct MeshSample
{
    Point3 point;
    Vec3 normal; //!< of its face, unit; zero where the face has no area
};

//! Vertices, middles of sides and centroids of faces: all of them where there are no more than `most`, else
//! `most` of them at even steps through the mesh. No two faces need agree on a normal.
std::vector<MeshSample> mesh_landmarks(const TriangleMesh& mesh, std::size_t most);

//! `count` points, the same number on every piece of the surface of equal area: the area in the order of the
//! faces is cut into `count` equal parts, and each holds one random point. None where the mesh has no area.
std::vector<MeshSample> area_samples(const TriangleMesh& mesh, std::size_t count, Random& random);

//! The same where area(mesh) is known.
std::vector<MeshSample> area_samples(const TriangleMesh& mesh, double total_area, std::size_t count,
                                     Random& random);

//! Length of a typical edge: of the equilateral triangle of the mean area; 0 where the mesh has no area.
double typical_edge_length(const TriangleMesh& mesh);
double typical_edge_length(const TriangleMesh& mesh, double total_area);

} // namespace voroprobe
