#include "postprocess/shift_bound.h"

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"

namespace voroprobe
{
namespace
{

TriangleMesh scaled(TriangleMesh mesh, double factor)
{
    for (Point3& p : mesh.vertices)
        p = factor * p;
    return mesh;
}

TEST(ShiftBound, holds_within_its_reach_and_no_farther)
{
    const TriangleMesh sphere = sample::icosphere(3, 10.0);
    const ShiftBound bound(sphere, 0.5);
    ShiftBound::OfPatch of_sphere = bound.around(sphere);
    EXPECT_TRUE(of_sphere.holds(sphere));
    EXPECT_TRUE(of_sphere.holds(scaled(sphere, 1.03)));
    EXPECT_FALSE(of_sphere.holds(scaled(sphere, 1.2)));
}

TEST(ShiftBound, is_of_the_original_and_not_of_the_steps)
{
    const TriangleMesh sphere = sample::icosphere(3, 10.0);
    const ShiftBound bound(sphere, 0.5);
    const TriangleMesh halfway = scaled(sphere, 1.04);
    EXPECT_FALSE(bound.around(halfway).holds(scaled(sphere, 1.08)));
}

TEST(ShiftBound, allows_a_share_of_its_reach_where_less_is_asked)
{
    const TriangleMesh sphere = sample::icosphere(3, 10.0);
    const ShiftBound bound(sphere, 0.5);
    const TriangleMesh larger = scaled(sphere, 1.03);
    EXPECT_TRUE(bound.around(sphere, 1.0).holds(larger));
    EXPECT_FALSE(bound.around(sphere, 0.5).holds(larger));
    EXPECT_TRUE(bound.around(larger, 0.5).holds(larger)) << "what is farther already may stay there";
}

TEST(ShiftBound, sees_what_was_cut_off)
{
    TriangleMesh spike = sample::tetrahedron();
    const TriangleMesh blunt = spike;
    spike.vertices[0] =
        spike.vertices[0] +
        5.0 * (spike.vertices[0] - (spike.vertices[1] + spike.vertices[2] + spike.vertices[3]) / 3.0);
    const ShiftBound bound(spike, 0.5);
    EXPECT_FALSE(
        bound.around(spike).holds(blunt)); // all of it is near the spike, but not the other way round
}

} // namespace
} // namespace voroprobe
