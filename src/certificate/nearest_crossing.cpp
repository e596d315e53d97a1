#include "certificate/nearest_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voroprobe
{

namespace
{

//! Points this near to a crossing, as a share of the first reach, lie on it: files store 24 bits or more.
constexpr double kOnSurface = 1e-6;

//! Each search without an answer is followed by one so many times as far.
constexpr double kNextReach = 4.0;

//! Searches along the surface's own normal. Each leaves an error of the second order in the angle it
//! corrects.
constexpr int kProjections = 2;

//! The plane of the surface is taken from points that far apart, as a share of the distance to it.
constexpr double kNormalBase = 0.5;

//! The edges and diagonals of a cube, one of each opposite pair.
std::array<Vec3, 13> lattice_directions()
{
    std::array<Vec3, 13> directions{Vec3{1, 0, 0},  Vec3{0, 1, 0}, Vec3{0, 0, 1},  Vec3{1, 1, 0},
                                    Vec3{1, -1, 0}, Vec3{1, 0, 1}, Vec3{1, 0, -1}, Vec3{0, 1, 1},
                                    Vec3{0, 1, -1}, Vec3{1, 1, 1}, Vec3{1, 1, -1}, Vec3{1, -1, 1},
                                    Vec3{-1, 1, 1}};
    for (Vec3& direction : directions)
        direction = normalized(direction);
    return directions;
}

//! A unit vector at right angles to a unit vector.
Vec3 any_perpendicular(const Vec3& u)
{
    const Vec3 least = std::abs(u.x) <= std::min(std::abs(u.y), std::abs(u.z)) ? Vec3{1, 0, 0}
                       : std::abs(u.y) <= std::abs(u.z)                        ? Vec3{0, 1, 0}
                                                                               : Vec3{0, 0, 1};
    return normalized(cross(u, least));
}

} // namespace

auto NearestCrossing::along(const Point3& p, const Vec3& direction, double reach) -> std::optional<Found>
{
    oracle_.find_crossings({p - reach * direction, p + reach * direction}, crossings_);
    std::optional<Found> nearest;
    for (const Crossing& crossing : crossings_)
    {
        const double distance_to_it = distance(p, crossing.point);
        const bool counts = caps_ == BorderCaps::kCounted || !crossing.on_border;
        if (counts && (!nearest || distance_to_it < nearest->distance))
            nearest = Found{crossing, direction, distance_to_it};
    }
    return nearest;
}

auto NearestCrossing::in_all_directions(const Point3& p, double reach) -> std::optional<Found>
{
    static const std::array<Vec3, 13> kDirections = lattice_directions();
    std::optional<Found> nearest;
    for (const Vec3& direction : kDirections)
        if (const auto found = along(p, direction, nearest ? nearest->distance : reach))
            if (!nearest || found->distance < nearest->distance)
                nearest = found;
    return nearest;
}

//! From two crossings beside the one found, on segments parallel to its own.
std::optional<Vec3> NearestCrossing::normal_at(const Point3& p, const Found& found)
{
    const double base = kNormalBase * found.distance;
    const Vec3 u = any_perpendicular(found.direction);
    const Vec3 v = cross(found.direction, u);
    const auto beside_u = along(p + base * u, found.direction, 2.0 * found.distance);
    const auto beside_v = along(p + base * v, found.direction, 2.0 * found.distance);
    if (!beside_u || !beside_v)
        return std::nullopt;
    const Vec3 normal = normalized(cross(beside_u->crossing.point - found.crossing.point,
                                         beside_v->crossing.point - found.crossing.point));
    return normal == Vec3{} ? std::nullopt : std::optional(normal);
}

auto NearestCrossing::projected(const Point3& p, Found found) -> Found
{
    for (int i = 0; i < kProjections; ++i)
    {
        const auto normal = normal_at(p, found);
        const auto closer = normal ? along(p, *normal, found.distance) : std::nullopt;
        if (!closer || closer->distance >= found.distance)
            break;
        found = *closer;
    }
    return found;
}

auto NearestCrossing::near(const Point3& p, const Vec3& likely_normal, double first_reach, double last_reach)
    -> std::optional<Found>
{
    std::optional<Found> found;
    if (likely_normal != Vec3{})
        found = along(p, likely_normal, std::min(first_reach, last_reach));
    for (double reach = std::min(first_reach, last_reach); !found;
         reach = std::min(kNextReach * reach, last_reach))
    {
        found = in_all_directions(p, reach);
        if (reach >= last_reach)
            break;
    }
    if (!found || found->distance <= kOnSurface * first_reach)
        return found;
    return projected(p, *found);
}

} // namespace voroprobe
