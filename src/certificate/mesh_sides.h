#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "certificate/face_tree.h"

namespace voroprobe
{

//! Of each point 1 where a mesh encloses it, else 0: by the parity of the faces that segments from it to
//! beyond the mesh meet, most of three. A mesh that is not closed gives no answer worth having. Cost: O(log
//! n) a point for n faces, on all cores.
std::vector<std::uint8_t> enclosed_by(const FaceTree& tree, std::span<const Point3> points);

} // namespace voroprobe
