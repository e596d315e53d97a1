#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesher/restricted_delaunay.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! The crossing nearest to a seed, along 26 directions; nullopt where there is none nearer than `reach`.
//! Within the reach the nearest point of the surface is unique, so the seed cannot be meant for another
//! component. Adds its queries to `query_count`. Cost: 13 short queries.
std::optional<Point3> snap_to_surface(const SurfaceOracle& oracle, const Point3& seed, double reach,
                                      std::size_t& query_count);

//! Points on the surface as CGAL's Surface_mesher finds them: crossings of rays from the domain's center in
//! uniformly random directions, the nearest on each, until there are `count`. Fewer where kMostRaysPerPoint
//! rays per point do not find them. Source: Feree & Alliez 2009, Sec. 3.
std::vector<Point3> random_surface_points(const SurfaceOracle& oracle, std::size_t count, std::uint64_t seed,
                                          std::size_t& query_count);

//! Number of pieces of the mesh as it stands. Cost: O(facets).
std::size_t count_pieces(const RestrictedDelaunay& restricted);

} // namespace voroprobe
