#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/refinement.h"
#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! The surfaces of the oracle's inventory without a facet of their own; none where there is no inventory.
//! Cost: O(facets).
std::vector<SurfaceId> find_missing_surfaces(const RestrictedDelaunay& restricted);

//! Where facets do not lie on one surface of the inventory although refinement has ended: they are at the
//! floor. Cost: O(facets).
std::vector<Point3> find_unfaithful_places(const RestrictedDelaunay& restricted);

//! Where the seeds of a surface come from.
enum class Seeds
{
    kOnGrid, //!< its crossings with the edges of the grid
    kOnRays  //!< its crossings with rays from the middle of those
};

//! Gives each surface up to `points` points, spread over it. Returns the number of points inserted.
std::size_t seed_surfaces(std::span<const SurfaceId> surfaces, std::size_t points, Seeds seeds,
                          const SurfaceOracle& oracle, Refinement& refinement);

//! Points of the surface around the middle of each neck: where the axes through it meet the surface next to
//! it.
std::vector<Point3> points_around(std::span<const Neck> necks, double floor_radius,
                                  const SurfaceOracle& oracle);

//! Inserts the points, but none nearer to a vertex than the floor. Returns the number of points inserted.
std::size_t seed_points(std::span<const Point3> points, double floor_radius,
                        const RestrictedDelaunay& restricted, Refinement& refinement);

} // namespace voroprobe
