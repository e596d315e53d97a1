#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Whether two faces of a mesh meet in more than the corners and edges they share. Exact predicates. Faces
//! that share an edge cross where one is folded onto the other.
bool faces_cross(const TriangleMesh& mesh, const TriangleMesh::Face& f, const TriangleMesh::Face& g);

} // namespace voroprobe
