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
//! without area, in ascending order. Exact: decided by filtered predicates. \pre coordinates are finite.
//! Cost: O(n log^2 n) box tests and one exact test per pair of overlapping boxes, on all cores; about a
//! second for a million faces. Source: Zomorodian & Edelsbrunner, Fast software for box intersections, 2002.
std::vector<FacePair> self_intersections(const TriangleMesh& mesh);

} // namespace voroprobe
