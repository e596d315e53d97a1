#pragma once

#include <cstddef>
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

//! Is one of the first `count` faces without area, or does it meet any other face elsewhere than in the
//! corners and edges they share by index? As exact as self_intersections(). For a few faces and what lies
//! around them: `count` times n box tests, on this thread. \pre coordinates are finite; `count` <= n.
bool first_faces_intersect(const TriangleMesh& mesh, std::size_t count);

} // namespace voroprobe
