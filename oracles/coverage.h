#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! Points of the surfaces of the oracle's inventory farther than `radius` from every vertex of a mesh on the
//! same surface, one in each cube of side `spacing` at most: there the mesh lacks a part of the surface. None
//! where there is no inventory.
//!
//! A restricted Delaunay triangulation that has all of the surface, and whose surface Delaunay balls have
//! radius R, covers it with these balls: no point is farther than 2 R from a vertex. Where few vertices lie
//! at one end of a long thin part, their Voronoi edges pass it by and all criteria hold without it. Source:
//! Boissonnat & Oudot, Provably good sampling and meshing of surfaces, 2005 (loose samples).
//! Frame: the oracle's; lengths in scan units, above 0. `threads`: 0 for all there are; the answer is the
//! same for any. Cost: one pass over the samples, and O(n log n) for n vertices.
std::vector<SurfacePoint> find_uncovered_points(const SurfaceOracle& oracle,
                                                std::span<const SurfacePoint> vertices, double radius,
                                                double spacing, std::size_t threads);

//! The same among points that are not much farther than `radius` from one of the places on the same surface:
//! from those that are not covered themselves.
std::vector<SurfacePoint> find_uncovered_points_near(std::vector<SurfacePoint> places,
                                                     const SurfaceOracle& oracle,
                                                     std::span<const SurfacePoint> vertices, double radius,
                                                     double spacing, std::size_t threads);

} // namespace voroprobe
