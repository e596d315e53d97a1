#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "certificate/self_intersections.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "postprocess/decimation.h"
#include "postprocess/deviation.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

using sample::append;
using sample::icosphere;
using sample::torus;

TEST(Decimation, a_count_of_faces_is_met_and_the_topology_kept)
{
    TriangleMesh mesh = torus(120, 60);
    append(mesh, icosphere(3, 1.0), {10, 0, 0});
    const DecimationResult result = decimate(mesh, {.faces = 3000});
    EXPECT_LE(result.mesh.faces.size(), 3000U);
    EXPECT_GT(result.mesh.faces.size(), 2900U);
    EXPECT_TRUE(is_closed_manifold(result.mesh));
    EXPECT_EQ(count_components(result.mesh), 2U);
    EXPECT_EQ(euler_characteristic(result.mesh), 2);
    EXPECT_TRUE(self_intersections(result.mesh).empty());
}

TEST(Decimation, the_error_bound_holds)
{
    const TriangleMesh mesh = icosphere(5, 10.0);
    for (const double bound : {0.01, 0.1})
    {
        const DecimationResult result = decimate(mesh, {.max_distance = bound});
        EXPECT_LT(result.mesh.faces.size(), mesh.faces.size() / 2);
        EXPECT_LE(deviation(mesh, result.mesh).max, 2.0 * bound);
    }
}

TEST(Decimation, no_angle_falls_below_the_one_asked_for)
{
    const TriangleMesh mesh = icosphere(4, 10.0); // smallest angle above 50 degrees
    for (const double angle : {20.0, 35.0})
        EXPECT_GE(measure_angles(decimate(mesh, {.faces = 200, .min_angle_deg = angle}).mesh).min_deg,
                  angle - 1e-9);
}

TEST(Decimation, a_piece_never_falls_flat)
{
    TriangleMesh mesh = icosphere(1);
    append(mesh, sample::tetrahedron(), {5, 0, 0});
    const DecimationResult result = decimate(mesh, {.faces = 4, .min_angle_deg = 0.0});
    EXPECT_TRUE(is_closed_manifold(result.mesh));
    EXPECT_EQ(count_components(result.mesh), 2U);
    EXPECT_EQ(euler_characteristic(result.mesh), 4);
}

TEST(Decimation, a_bound_is_required)
{
    EXPECT_THROW(decimate(icosphere(1), {}), UsageError);
    EXPECT_THROW(decimate(icosphere(1), {.max_distance = -1.0}), UsageError);
    EXPECT_THROW(decimate(icosphere(1), {.faces = 10, .min_angle_deg = 60.0}), UsageError);
}

} // namespace
} // namespace voroprobe
