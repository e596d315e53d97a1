// A closed piece on a surface need not be all of it: where facets may be long, a few of them close around one
// end of a thin part.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/trilinear_oracle.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

constexpr std::size_t kLength = 48; // samples
constexpr long kFirst = 4;          // on the rod
constexpr long kLast = 43;

//! A rod of single samples along x.
double height(const Point3& p)
{
    const bool on_rod = std::lround(p.x) >= kFirst && std::lround(p.x) <= kLast && std::lround(p.y) == 4 &&
                        std::lround(p.z) == 4;
    return on_rod ? 1.0 : -1.0;
}

struct Ends
{
    double low = 1e300;
    double high = -1e300;
};

Ends ends_along_x(const TriangleMesh& mesh)
{
    Ends ends;
    for (const Point3& vertex : mesh.vertices)
    {
        ends.low = std::min(ends.low, vertex.x);
        ends.high = std::max(ends.high, vertex.x);
    }
    return ends;
}

TEST(Ends, of_a_thin_rod_are_meshed_with_large_facets)
{
    const auto volume = std::make_shared<Volume>(sample_volume(height, {kLength, 9, 9}, {1, 1, 1}));
    const LevelledVolume levelled = level_volume(volume, 0.0);
    const auto inventory = std::make_shared<const Inventory>(*make_height_field(levelled), 1);
    const auto oracle = make_trilinear_oracle(levelled, inventory);
    std::size_t reached_by_coverage = 0;
    for (const double radius : {1.5, 2.0, 3.0, 4.0, 6.0})
    {
        const MeshingResult result = mesh_surface(
            *oracle, {.max_facet_radius = radius, .floor_radius = 0.25, .reach_lower_bound = 1.0});
        const MeshTopology topology = analyze_topology(result.mesh);
        EXPECT_TRUE(topology.closed()) << radius;
        EXPECT_EQ(topology.components, 1U) << radius;
        const Ends ends = ends_along_x(result.mesh);
        EXPECT_LE(ends.low, kFirst + 2.0 * radius) << radius;
        EXPECT_GE(ends.high, kLast - 2.0 * radius) << radius;
        reached_by_coverage += result.statistics.uncovered_points > 0 ? 1 : 0;
    }
    EXPECT_GT(reached_by_coverage, 0U); // otherwise the rod is no test of it
}

} // namespace
} // namespace voroprobe
