#include "mesher/seeding.h"

#include <array>
#include <cmath>
#include <numbers>

#include "support/random.h"
#include "support/union_find.h"

namespace voroprobe
{
namespace
{

constexpr std::size_t kMostRaysPerPoint = 100;

//! One of each pair of opposite directions from the center of a cube to its corners, edges and sides.
std::array<Vec3, 13> snapping_directions()
{
    std::array<Vec3, 13> directions;
    std::size_t count = 0;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
            {
                const bool first_of_pair = x > 0 || (x == 0 && (y > 0 || (y == 0 && z > 0)));
                if (first_of_pair)
                    directions[count++] = normalized(Vec3{1.0 * x, 1.0 * y, 1.0 * z});
            }
    return directions;
}

Vec3 random_direction(Random& random)
{
    const double z = random.uniform(-1.0, 1.0);
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

} // namespace

std::optional<Point3> snap_to_surface(const SurfaceOracle& oracle, const Point3& seed, double reach,
                                      std::size_t& query_count)
{
    std::vector<Crossing> crossings;
    std::optional<Point3> nearest;
    for (const Vec3& direction : snapping_directions())
    {
        ++query_count;
        oracle.find_crossings({seed - reach * direction, seed + reach * direction}, crossings);
        for (const Crossing& crossing : crossings)
        {
            if (!nearest || squared_distance(crossing.point, seed) < squared_distance(*nearest, seed))
                nearest = crossing.point;
        }
    }
    return nearest;
}

std::vector<Point3> random_surface_points(const SurfaceOracle& oracle, std::size_t count, std::uint64_t seed,
                                          std::size_t& query_count)
{
    Random random(seed);
    const Point3 center = oracle.domain().center();
    const double length = 0.5 * oracle.domain().diagonal();
    std::vector<Crossing> crossings;
    std::vector<Point3> points;
    for (std::size_t ray = 0; ray < kMostRaysPerPoint * count && points.size() < count; ++ray)
    {
        ++query_count;
        oracle.find_crossings({center, center + length * random_direction(random)}, crossings);
        if (!crossings.empty())
            points.push_back(crossings.front().point);
    }
    return points;
}

std::size_t count_pieces(const RestrictedDelaunay& restricted)
{
    UnionFind pieces(restricted.vertex_index_bound());
    std::vector<bool> used(restricted.vertex_index_bound(), false);
    for (FacetId id = 0; id < restricted.facet_slots(); ++id)
    {
        const RestrictedFacet& facet = restricted.facet(id);
        if (!facet.odd())
            continue;
        pieces.unite(facet.vertices[0], facet.vertices[1]);
        pieces.unite(facet.vertices[0], facet.vertices[2]);
        used[facet.vertices[0]] = used[facet.vertices[1]] = used[facet.vertices[2]] = true;
    }
    std::size_t count = 0;
    for (std::uint32_t vertex = 0; vertex < used.size(); ++vertex)
        count += used[vertex] && pieces.find(vertex) == vertex ? 1 : 0;
    return count;
}

} // namespace voroprobe
