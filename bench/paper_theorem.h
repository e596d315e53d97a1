#pragma once

#include <cstddef>
#include <cstdint>

#include "bench/paper_report.h"

namespace voroprobe::bench
{

//! Meshes surfaces whose reach is known by the book: size 0.091 times a bound just below the reach,
//! persistent first triangles, one isolated vertex at a time, probing. Checks that every mesh is a copy of
//! its surface, component by component, and that the Hausdorff distance stays under 4.5 diam size^2 / reach,
//! with the diameter of the largest component. Three random spheres and one random torus in each trial; the
//! implicit surface of Figure 8 once. Source: Feree & Alliez 2009, Sec. 1.1 (from Boissonnat & Oudot 2005).
Report check_theorem(std::size_t trials, std::uint64_t seed);

} // namespace voroprobe::bench
