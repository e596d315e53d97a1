#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>

#include "../mesh/sample_meshes.h"
#include "certificate/self_intersections.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "postprocess/deviation.h"
#include "postprocess/relaxation.h"
#include "support/error.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

using sample::icosphere;
using sample::torus;

//! Moves vertices at random within the surface of a sphere about the origin.
TriangleMesh shaken_sphere()
{
    TriangleMesh mesh = icosphere(4, 10.0);
    Random random(1);
    for (Point3& p : mesh.vertices)
        p = 10.0 * normalized(p + Vec3{random.uniform(-0.22, 0.22), random.uniform(-0.22, 0.22),
                                       random.uniform(-0.22, 0.22)});
    return mesh;
}

RelaxationResult relaxed(const TriangleMesh& mesh, double max_distance)
{
    return relax(mesh, projection_onto(std::make_shared<const MeshDistance>(mesh)),
                 {.max_distance = max_distance});
}

TEST(Relaxation, raises_every_angle_of_a_shaken_sphere_above_33_degrees)
{
    const TriangleMesh before = shaken_sphere();
    ASSERT_LT(measure_angles(before).min_deg, 20.0);
    const RelaxationResult result = relaxed(before, 0.2);
    EXPECT_TRUE(is_closed_manifold(result.mesh));
    EXPECT_EQ(euler_characteristic(result.mesh), 2);
    EXPECT_GE(measure_angles(result.mesh).min_deg, 33.0);
    EXPECT_GE(measure_angles(result.mesh).mean_min_deg, 48.0);
    EXPECT_TRUE(self_intersections(result.mesh).empty());
    EXPECT_LE(deviation(before, result.mesh).max, 0.2);
}

TEST(Relaxation, keeps_handles)
{
    const RelaxationResult result = relaxed(torus(60, 12), 0.1);
    EXPECT_TRUE(is_closed_manifold(result.mesh));
    EXPECT_EQ(euler_characteristic(result.mesh), 0);
    EXPECT_EQ(count_components(result.mesh), 1U);
    EXPECT_GT(measure_angles(result.mesh).min_deg, measure_angles(torus(60, 12)).min_deg);
}

TEST(Relaxation, sheets_that_all_but_touch_stay_apart)
{
    TriangleMesh mesh = shaken_sphere();
    TriangleMesh inner = shaken_sphere();
    for (Point3& p : inner.vertices)
        p = 0.998 * p;
    for (TriangleMesh::Face& face : inner.faces)
        std::swap(face[1], face[2]);
    sample::append(mesh, inner);
    ASSERT_TRUE(self_intersections(mesh).empty());
    const RelaxationResult result = relaxed(mesh, 0.2);
    EXPECT_TRUE(self_intersections(result.mesh).empty());
    EXPECT_EQ(result.self_intersections, 0U);
    EXPECT_EQ(count_components(result.mesh), 2U);
    EXPECT_EQ(euler_characteristic(result.mesh), 4);
}

TEST(Relaxation, the_smallest_meshes_survive)
{
    for (const TriangleMesh& mesh : {sample::tetrahedron(), sample::icosahedron()})
    {
        const RelaxationResult result = relaxed(mesh, 0.1);
        EXPECT_TRUE(is_closed_manifold(result.mesh));
        EXPECT_EQ(euler_characteristic(result.mesh), 2);
        EXPECT_GT(enclosed_volume(result.mesh), 0.0);
    }
}

TEST(Relaxation, options_out_of_range_are_refused)
{
    EXPECT_THROW(relaxed(sample::tetrahedron(), 0.0), UsageError);
}

} // namespace
} // namespace voroprobe
