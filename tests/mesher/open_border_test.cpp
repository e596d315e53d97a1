#include <gtest/gtest.h>

#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/trilinear_oracle.h"
#include "random_volumes.h"

namespace voroprobe
{
namespace
{

TEST(OpenBorder, leaves_a_manifold_with_a_rim_also_after_welding)
{
    for (const VolumeKind kind :
         {VolumeKind::kThroughBorder, VolumeKind::kSmoothNoise, VolumeKind::kWhiteNoise})
    {
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
        {
            const RandomVolume random = make_random_volume(kind, seed);
            SCOPED_TRACE(random.name);
            const auto oracle = make_trilinear_oracle(random.volume, random.isovalue);
            const MeshingResult result = mesh_surface(*oracle, {.max_facet_radius = 1.0,
                                                                .max_facet_distance = 0.2,
                                                                .floor_radius = 0.2,
                                                                .reach_lower_bound = 0.5,
                                                                .close_border = false});
            const MeshTopology topology = analyze_topology(weld(result.mesh));
            EXPECT_GT(topology.boundary_edges, 0U);
            EXPECT_TRUE(topology.manifold());
            EXPECT_TRUE(topology.oriented());
            EXPECT_EQ(topology.unused_vertices, 0U);
        }
    }
}

} // namespace
} // namespace voroprobe
