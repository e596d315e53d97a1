#include "mesher/faithfulness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace voroprobe
{
namespace
{

//! How far from the middle of a neck its surface is looked for: a voxel, at the default floor.
constexpr double kReachOfNeckInFloors = 4.0;

constexpr std::array<Vec3, 6> kAxes{{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

//! The n-th of `count` unit vectors spread evenly: a spiral from pole to pole. Source: Swinbank & Purser,
//! Fibonacci grids, 2006.
Vec3 direction(std::size_t n, std::size_t count)
{
    const double z = 1.0 - (2.0 * static_cast<double>(n) + 1.0) / static_cast<double>(count);
    const double longitude = 2.0 * std::numbers::pi * (static_cast<double>(n) * std::numbers::phi);
    const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
    return {radius * std::cos(longitude), radius * std::sin(longitude), z};
}

//! First hits, on the surface, of `count` rays from the middle of some of its points, spread as on an
//! ellipsoid around them: the corners of flat specks lie on one circle, on which no facet would stand. Where
//! the middle itself lies next to the surface, hits beside it are passed over: they would be a cluster.
std::vector<Point3> hits_of_rays(const SurfaceOracle& oracle, SurfaceId surface,
                                 std::span<const Point3> points, std::size_t count)
{
    constexpr double kReachInExtents = 2.0;
    constexpr double kLeastParameter = 1.0 / 16.0;
    Box3 box;
    for (const Point3& p : points)
        box.include(p);
    std::vector<Point3> hits;
    if (box.empty())
        return hits;
    std::vector<Crossing> crossings;
    for (std::size_t n = 0; n < count; ++n)
    {
        const Vec3 unit = direction(n, count);
        const Vec3 extent = box.extent();
        const Vec3 ray{unit.x * extent.x, unit.y * extent.y, unit.z * extent.z};
        oracle.find_crossings({box.center(), box.center() + kReachInExtents * ray}, crossings);
        const auto hit = std::find_if(crossings.begin(), crossings.end(),
                                      [&](const Crossing& crossing) {
                                          return crossing.t >= kLeastParameter &&
                                                 oracle.surface_at(crossing.point) == surface;
                                      });
        if (hit != crossings.end())
            hits.push_back(hit->point);
    }
    return hits;
}

// How many facets ahead the cells on either side of the next are asked for: they lie anywhere in memory.
constexpr FacetId kPrefetchDistance = 16;

//! Has the cells of facets fetched that come after this one.
void prefetch_after(const RestrictedDelaunay& restricted, FacetId id)
{
    const FacetId farther = id + 2 * kPrefetchDistance;
    const FacetId nearer = id + kPrefetchDistance;
    if (farther < restricted.facet_slots() && restricted.facet(farther).crossing_count != 0)
        prefetch(restricted.facet(farther).delaunay_cell);
    if (nearer < restricted.facet_slots() && restricted.facet(nearer).crossing_count != 0)
        prefetch(restricted.facet(nearer).delaunay_cell->neighbor(restricted.facet(nearer).index));
}

} // namespace

std::vector<SurfaceId> find_missing_surfaces(const RestrictedDelaunay& restricted)
{
    std::vector<bool> has_facet(restricted.oracle().surface_count(), false);
    if (has_facet.empty())
        return {};
    for (FacetId id = 0; id < restricted.facet_slots(); ++id)
    {
        prefetch_after(restricted, id);
        const RestrictedFacet& facet = restricted.facet(id);
        if (!facet.odd())
            continue;
        const SurfaceId surface = restricted.surface(facet);
        if (surface != kNoSurface)
            has_facet[static_cast<std::size_t>(surface)] = true;
    }
    std::vector<SurfaceId> missing;
    for (std::size_t surface = 0; surface < has_facet.size(); ++surface)
    {
        if (!has_facet[surface])
            missing.push_back(static_cast<SurfaceId>(surface));
    }
    return missing;
}

std::vector<Point3> find_unfaithful_places(const RestrictedDelaunay& restricted)
{
    std::vector<Point3> places;
    for (FacetId id = 0; id < restricted.facet_slots(); ++id)
    {
        prefetch_after(restricted, id);
        const RestrictedFacet& facet = restricted.facet(id);
        if (facet.crossing_count == 0)
            continue;
        const bool faithful = facet.odd() ? restricted.is_faithful(facet)
                                          : facet.delaunay_cell->info().region ==
                                                facet.delaunay_cell->neighbor(facet.index)->info().region;
        if (!faithful)
            places.push_back(facet.center);
    }
    return places;
}

std::size_t seed_surfaces(std::span<const SurfaceId> surfaces, std::size_t points, Seeds seeds,
                          const SurfaceOracle& oracle, Refinement& refinement)
{
    std::size_t inserted = 0;
    VertexHandle last;
    const std::vector<std::vector<Point3>> points_of_surface = oracle.points_on(surfaces, points);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
    {
        std::vector<Point3> places = points_of_surface[i];
        if (seeds == Seeds::kOnRays)
            places = hits_of_rays(oracle, surfaces[i], places, points);
        for (const Point3& p : places)
        {
            const VertexHandle vertex = refinement.insert(p, VertexOrigin::kInventory, last);
            if (vertex == VertexHandle())
                continue; // a vertex already
            last = vertex;
            ++inserted;
        }
    }
    return inserted;
}

std::vector<Point3> points_around(std::span<const Neck> necks, double floor_radius,
                                  const SurfaceOracle& oracle)
{
    std::vector<Point3> points;
    std::vector<Crossing> crossings;
    for (const Neck& neck : necks)
    {
        for (const Vec3& direction : kAxes)
        {
            const Vec3 ray = kReachOfNeckInFloors * floor_radius * direction;
            oracle.find_crossings({neck.middle, neck.middle + ray}, crossings);
            if (!crossings.empty())
                points.push_back(crossings.front().point);
        }
    }
    return points;
}

std::size_t seed_points(std::span<const Point3> points, double floor_radius,
                        const RestrictedDelaunay& restricted, Refinement& refinement)
{
    std::size_t inserted = 0;
    VertexHandle last = restricted.triangulation().finite_vertices_begin();
    for (const Point3& p : points)
    {
        if (!restricted.is_apart(p, floor_radius, last))
            continue;
        last = refinement.insert(p, VertexOrigin::kRefinement, last);
        ++inserted;
    }
    return inserted;
}

} // namespace voroprobe
