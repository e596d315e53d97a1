#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec3.h"

namespace voroprobe
{

//! The numbers of some points in an order in which neighbours in the list are neighbours in space: of every
//! 2^n that begin at a multiple of 2^n, from 4 on, the first half lies on one side of a plane across an axis
//! and the second on the other. \pre finite coordinates. Cost: O(n log n), on all cores; about 0.12 s for a
//! million points. Deterministic.
std::vector<std::uint32_t> order_in_space(std::span<const Point3> points);

} // namespace voroprobe
