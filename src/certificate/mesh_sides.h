#pragma once

#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Of each point whether a mesh encloses it: by the parity of the faces that segments from it to beyond the
//! mesh meet, most of three. A mesh that is not closed gives no answer worth having. Cost: O(n log n) for n
//! faces, then O(log n) a point.
std::vector<bool> enclosed_by(const TriangleMesh& mesh, std::span<const Point3> points);

} // namespace voroprobe
