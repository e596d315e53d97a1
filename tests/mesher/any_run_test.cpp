// Whatever the volume, the mesh is closed, oriented, manifold and free of self-intersections, for readers
// that weld equal points and for those that round to 32-bit floats first.

#include "mesher/seeded_mesher.h"

#include <vector>

#include <gtest/gtest.h>

#include "io/float_rounding.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "oracles/trilinear_oracle.h"
#include "random_volumes.h"
#include "self_intersections.h"

namespace voroprobe
{
namespace
{

void expect_sound(const TriangleMesh& mesh)
{
    const MeshTopology topology = analyze_topology(mesh);
    EXPECT_EQ(topology.boundary_edges, 0U);
    EXPECT_EQ(topology.degenerate_faces, 0U);
    EXPECT_EQ(topology.non_manifold_edges, 0U);
    EXPECT_EQ(topology.non_manifold_vertices, 0U);
    EXPECT_EQ(topology.misoriented_edges, 0U);
    EXPECT_EQ(topology.unused_vertices, 0U);
    EXPECT_EQ(find_self_intersections(mesh), std::vector<FacePair>{});
    EXPECT_GT(enclosed_volume(mesh), 0.0);
}

//! What a writer of 32-bit floats makes of a mesh that takes no care.
TriangleMesh rounded_plainly(TriangleMesh mesh)
{
    for (Point3& p : mesh.vertices)
        for (std::size_t axis = 0; axis < 3; ++axis)
            p[axis] = static_cast<double>(static_cast<float>(p[axis]));
    return mesh;
}

void expect_sound_for_every_reader(const RandomVolume& random)
{
    SCOPED_TRACE(random.name);
    const auto oracle = make_trilinear_oracle(random.volume, random.isovalue);
    const double voxel = random.volume->geometry.min_spacing();
    const MeshingResult result = mesh_surface(*oracle, {.max_facet_radius = 2.0 * voxel,
                                                        .max_facet_distance = 0.3 * voxel,
                                                        .floor_radius = 0.25 * voxel,
                                                        .reach_lower_bound = 0.5 * voxel});
    ASSERT_EQ(result.status, MeshingStatus::kDone);
    ASSERT_FALSE(result.mesh.faces.empty());
    EXPECT_EQ(result.statistics.contacts_carved, 0U);
    {
        SCOPED_TRACE("welded");
        expect_sound(weld(result.mesh));
    }
    {
        SCOPED_TRACE("rounded to float plainly, welded");
        expect_sound(weld(rounded_plainly(result.mesh)));
    }
    {
        SCOPED_TRACE("rounded to float by the writer, welded");
        expect_sound(weld(round_to_float(result.mesh).mesh));
    }
}

class AnyRun : public testing::TestWithParam<VolumeKind>
{
};

TEST_P(AnyRun, is_closed_oriented_manifold_and_does_not_cross_itself)
{
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
        expect_sound_for_every_reader(make_random_volume(GetParam(), seed));
}

std::vector<VolumeKind> every_kind()
{
    std::vector<VolumeKind> kinds;
    for (int kind = 0; kind < kVolumeKindCount; ++kind)
        kinds.push_back(static_cast<VolumeKind>(kind));
    return kinds;
}

INSTANTIATE_TEST_SUITE_P(EveryKind, AnyRun, testing::ValuesIn(every_kind()),
                         [](const auto& kind) { return name_of(kind.param); });

} // namespace
} // namespace voroprobe
