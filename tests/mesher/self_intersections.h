#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Two faces by their numbers, the smaller first; twice the same number for a face without area.
using FacePair = std::pair<std::uint32_t, std::uint32_t>;

//! The pairs of faces that meet elsewhere than in the corners and edges they share by index, and the faces
//! without area, in ascending order. Exact: decided by CGAL's filtered predicates, independently of what
//! src/mesher uses. Cost: O(n log^2 n) box tests and one exact test per pair of overlapping boxes.
std::vector<FacePair> find_self_intersections(const TriangleMesh& mesh);

} // namespace voroprobe
