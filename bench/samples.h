#pragma once

#include <cstddef>
#include <vector>

#include "bench/contestant.h"
#include "geometry/vec3.h"

namespace voroprobe::bench
{

//! The samples as 32-bit floats, exact for integers of up to 24 bits. Non-finite ones become the lowest
//! float.
std::vector<float> to_float(const Volume& volume);

//! Points on the surface, on edges of the grid, up to `per_region` for each 6-connected set of inside
//! samples, spread over its border crossings. The same for the same input. For peers that have to be told
//! where the surface is.
std::vector<Point3> seeds_on_every_region(const GridGeometry& geometry, const std::vector<float>& samples,
                                          double isovalue, std::size_t per_region);

} // namespace voroprobe::bench
