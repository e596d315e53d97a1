#pragma once

#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! Whether a surface of the oracle's inventory is next to nothing without its caps: it comes nowhere farther
//! from the border of the domain than two `floor_radius` (scan units). Cost: that of points_on().
bool lies_in_border(const SurfaceOracle& oracle, SurfaceId surface, double floor_radius);

} // namespace voroprobe
