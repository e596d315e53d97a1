// Bridges and tunnels about as thin as the floor, and thinner.

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

constexpr double kHair = 0.2;   // height of samples whose neighbours are 1 below or above: 0.17 voxels
constexpr double kThread = 0.5; // 0.33 voxels

using Index = std::array<long, 3>;

template <class Height>
MeshTopology mesh_topology_of(const std::array<std::size_t, 3>& size, Height height)
{
    const auto at_point = [&](const Point3& p) {
        return height(Index{std::lround(p.x), std::lround(p.y), std::lround(p.z)});
    };
    const auto volume = std::make_shared<Volume>(sample_volume(at_point, size, {1, 1, 1}));
    const LevelledVolume levelled = level_volume(volume, 0.0);
    const auto inventory = std::make_shared<const Inventory>(*make_height_field(levelled), 1);
    const auto oracle = make_trilinear_oracle(levelled, inventory);
    return analyze_topology(mesh_surface(*oracle, {.max_facet_radius = 2.0,
                                                   .max_facet_distance = 0.3,
                                                   .floor_radius = 0.25,
                                                   .reach_lower_bound = 1.0})
                                .mesh);
}

void expect_one_piece(const MeshTopology& topology, long handles)
{
    EXPECT_TRUE(topology.closed());
    EXPECT_TRUE(topology.manifold());
    EXPECT_EQ(topology.components, 1U);
    EXPECT_EQ(topology.euler_characteristic, 2 - 2 * handles);
}

TEST(Handles, of_a_ring_of_single_samples_stay)
{
    const auto is_on_ring = [](const Index& s)
    {
        const bool in_square = s[0] >= 3 && s[0] <= 9 && s[1] >= 3 && s[1] <= 9 && s[2] == 3;
        return in_square && (s[0] == 3 || s[0] == 9 || s[1] == 3 || s[1] == 9);
    };
    expect_one_piece(
        mesh_topology_of({13, 13, 7}, [&](const Index& s) { return is_on_ring(s) ? kThread : -1.0; }), 1);
}

TEST(Handles, of_tunnels_through_a_block_stay)
{
    const auto height = [](const Index& s)
    {
        const bool in_block = s[0] >= 2 && s[0] <= 10 && s[1] >= 2 && s[1] <= 10 && s[2] >= 2 && s[2] <= 6;
        const bool in_tunnel = (s[0] == 4 && s[1] == 4) || (s[0] == 8 && s[1] == 7);
        return !in_block ? -1.0 : in_tunnel ? -kHair : 1.0;
    };
    expect_one_piece(mesh_topology_of({13, 13, 9}, height), 2);
}

TEST(Handles, of_blocks_joined_by_face_saddles_stay)
{
    // Two columns that touch along diagonals, at two heights: a handle.
    const auto height = [](const Index& s)
    {
        const bool in_columns = s[2] >= 2 && s[2] <= 9 &&
                                ((s[0] >= 2 && s[0] <= 4 && s[1] >= 2 && s[1] <= 4) ||
                                 (s[0] >= 5 && s[0] <= 7 && s[1] >= 5 && s[1] <= 7));
        const bool beside_contact = (s[0] == 4 && s[1] == 5) || (s[0] == 5 && s[1] == 4);
        if (in_columns)
            return 1.0;
        return beside_contact && (s[2] == 3 || s[2] == 8) ? -0.98 : beside_contact ? -1.02 : -1.0;
    };
    expect_one_piece(mesh_topology_of({10, 10, 12}, height), 1);
}

} // namespace
} // namespace voroprobe
