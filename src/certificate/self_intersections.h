#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "certificate/face_tree.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Two faces by their numbers, the smaller first; twice the same number for a face without area.
using FacePair = std::pair<std::uint32_t, std::uint32_t>;

//! The pairs of faces that meet elsewhere than in the corners and edges they share by index, and the faces
//! without area, in ascending order. Exact: decided by filtered predicates. \pre coordinates are finite.
//! Cost: O(n log n) box tests, and one exact test per pair of overlapping boxes but for pairs around a flat
//! star (see find_flat_stars), on all cores; about half a second for a million faces.
std::vector<FacePair> self_intersections(const TriangleMesh& mesh);

//! The same for a mesh whose tree there is.
std::vector<FacePair> self_intersections(const FaceTree& tree);

//! Takes the faces without area out of `pairs`, so that two faces meet in each that is left, and counts them.
std::size_t take_flat_faces(std::vector<FacePair>& pairs);

//! Is one of the first `count` faces without area, or does it meet any other face elsewhere than in the
//! corners and edges they share by index? As exact as self_intersections(). For a few faces and what lies
//! around them: `count` times n box tests, on this thread. \pre coordinates are finite; `count` <= n.
bool first_faces_intersect(const TriangleMesh& mesh, std::size_t count);

} // namespace voroprobe
