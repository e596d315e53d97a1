#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! For each vertex 1 where it is certain that the faces around it lie like a disk: each joins the next in one
//! round, and seen along some direction they all turn the same way and go round once. Then no two of them
//! have more in common than the corners and edges they share, and each has area. 0 where that is not so, or
//! too near to call: the arithmetic is that of doubles with bounds on its rounding, and never wrong. \pre
//! faces name existing vertices, coordinates are finite. Cost: O(n), on all cores; about 0.1 s for a million
//! faces.
std::vector<std::uint8_t> find_flat_stars(const TriangleMesh& mesh);

} // namespace voroprobe
