#pragma once

#include <cstddef>
#include <vector>

#include "volume/height_field.h"
#include "volume/inventory.h"
#include "volume/surface_point.h"

namespace voroprobe
{

//! Of every surface one point in each cube that it passes, of a grid of cubes of this side, or of single grid
//! cells where those are larger: the first of its crossings with grid edges there, in the order of memory;
//! samples on caps count as crossings.
//! `side`: scan units, above 0. `threads`: 0 for all there are; the result is the same for any. Cost: one
//! pass over the samples.
std::vector<SurfacePoint> spread_crossings(const HeightField& field, const Inventory& inventory, double side,
                                           std::size_t threads);

} // namespace voroprobe
