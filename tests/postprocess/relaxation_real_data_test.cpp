//! What relaxation promises, on the small scans of testdata.

#include <memory>

#include <gtest/gtest.h>

#include "certificate/mesh_samples.h"
#include "certificate/self_intersections.h"
#include "io/volume_reader.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/trilinear_oracle.h"
#include "postprocess/deviation.h"
#include "postprocess/relaxation.h"

namespace voroprobe
{
namespace
{

struct Scan
{
    const char* file;
    double isovalue;
};

void PrintTo(const Scan& scan, std::ostream* stream)
{
    *stream << scan.file;
}

class RelaxationOfScans : public testing::TestWithParam<Scan>
{
};

TEST_P(RelaxationOfScans, leaves_no_angle_below_33_degrees_and_keeps_topology_and_distance)
{
    const auto volume = std::make_shared<const Volume>(
        read_volume(std::string(VOROPROBE_SOURCE_DIR "/testdata/") + GetParam().file).volume);
    const double voxel = volume->geometry.min_spacing();
    const auto oracle = make_trilinear_oracle(volume, GetParam().isovalue);
    const TriangleMesh before = mesh_surface(*oracle, {.max_facet_radius = 2 * voxel,
                                                       .max_facet_distance = 0.3 * voxel,
                                                       .floor_radius = 0.25 * voxel,
                                                       .reach_lower_bound = voxel})
                                    .mesh;
    ASSERT_LT(measure_angles(before).min_deg, 33.0);
    const double edge = typical_edge_length(before);
    const BoundingSurface surface{
        projection_onto(*oracle, std::make_shared<const MeshDistance>(before), edge),
        face_distance_to(*oracle, edge), 0.3 * voxel};

    const RelaxationResult result = relax(before, surface);

    EXPECT_EQ(count_faces_below_angle(result.mesh, 33.0), 0U);
    EXPECT_EQ(result.short_faces.all(), 0U);
    EXPECT_GE(measure_angles(result.mesh).mean_min_deg, 48.0);
    EXPECT_TRUE(is_closed_manifold(result.mesh));
    EXPECT_EQ(count_components(result.mesh), count_components(before));
    EXPECT_EQ(euler_characteristic(result.mesh), euler_characteristic(before));
    EXPECT_TRUE(self_intersections(result.mesh).empty());
    EXPECT_LE(count_beyond(result.mesh, surface), count_beyond(before, surface));
    EXPECT_LE(deviation(before, result.mesh).max, edge);
}

INSTANTIATE_TEST_SUITE_P(Testdata, RelaxationOfScans,
                         testing::Values(Scan{"fuel.mha", 70.5}, Scan{"neghip.mha", 100.5},
                                         Scan{"marschner_lobb.mha", 128.5}));

} // namespace
} // namespace voroprobe
