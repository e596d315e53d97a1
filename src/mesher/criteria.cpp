#include "mesher/criteria.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace voroprobe
{
namespace
{

// Facets with a smaller ball, in floor radii, are never refined. Refinement for the angle keeps the shortest
// edge and needs no floor in theory; this bounds it where rounding spoils a ball.
constexpr double kSmallestBallInFloors = 1.0 / 64.0;

} // namespace

FacetCriteria::FacetCriteria(const MeshingOptions& options)
    : squared_size_(options.max_facet_radius * options.max_facet_radius),
      squared_distance_(options.max_facet_distance ? *options.max_facet_distance * *options.max_facet_distance
                                                   : std::numeric_limits<double>::infinity()),
      squared_sine_of_angle_(std::pow(std::sin(options.min_facet_angle_deg * std::numbers::pi / 180.0), 2)),
      floor_(options.floor_radius),
      squared_smallest_(kSmallestBallInFloors * kSmallestBallInFloors * floor_.squared_base())
{
}

std::optional<Badness> FacetCriteria::badness(const RestrictedFacet& facet,
                                              const std::array<Point3, 3>& corners) const
{
    if (facet.squared_radius <= squared_smallest_)
        return std::nullopt;
    if (facet.odd())
    {
        if (const auto badness = shape_badness(facet, corners))
            return badness;
    }
    if (facet.crossing_count > 1 && !at_floor(facet))
        return Badness::kUnresolved;
    return std::nullopt;
}

std::optional<Badness> FacetCriteria::badness(const RestrictedDelaunay& restricted, FacetId id) const
{
    const RestrictedFacet& facet = restricted.facet(id);
    if (const auto by_itself = badness(facet, restricted.corners(facet)))
        return by_itself;
    if (facet.odd() && !at_floor(facet) && !restricted.is_faithful(facet))
        return Badness::kUnfaithful;
    return std::nullopt;
}

std::optional<Badness> FacetCriteria::shape_badness(const RestrictedFacet& facet,
                                                    const std::array<Point3, 3>& corners) const
{
    if (facet.squared_radius > squared_size_)
        return Badness::kSize;

    // Edge lengths and area give the circumradius R; the smallest angle is opposite the shortest edge, whose
    // length is 2 R sin(angle). Circumcenter, ball center and corner form a right triangle.
    const double aa = squared_distance(corners[1], corners[2]);
    const double bb = squared_distance(corners[2], corners[0]);
    const double cc = squared_distance(corners[0], corners[1]);
    const double sixteen_squared_areas =
        squared_norm(cross(corners[1] - corners[0], corners[2] - corners[0])) * 4.0;
    const double squared_circumradius = aa * bb * cc / sixteen_squared_areas;
    if (facet.squared_radius - squared_circumradius > squared_distance_)
        return Badness::kDistance;
    if (std::min({aa, bb, cc}) < 4.0 * squared_circumradius * squared_sine_of_angle_)
        return Badness::kAngle;
    return std::nullopt;
}

} // namespace voroprobe
