#include <gtest/gtest.h>
#include <numbers>

#include "../mesh/sample_meshes.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "postprocess/bodies.h"

namespace voroprobe
{
namespace
{

using sample::append;
using sample::icosphere;

TriangleMesh inside_out(TriangleMesh mesh)
{
    for (TriangleMesh::Face& face : mesh.faces)
        std::swap(face[1], face[2]);
    return mesh;
}

//! A shell of radius 10 with a cavity of 8 in which a ball of 5 floats, and a ball of 3 beside it.
TriangleMesh nested()
{
    TriangleMesh mesh = icosphere(3, 3.0);
    for (Point3& p : mesh.vertices)
        p += Vec3{30, 0, 0};
    append(mesh, icosphere(3, 10.0));
    append(mesh, inside_out(icosphere(3, 8.0)));
    append(mesh, icosphere(3, 5.0));
    return mesh;
}

TEST(Bodies, a_cavity_belongs_to_the_shell_around_it)
{
    const TriangleMesh mesh = nested();
    const std::vector<Body> bodies = find_bodies(mesh, split_into_pieces(mesh));
    ASSERT_EQ(bodies.size(), 3U);
    EXPECT_TRUE(bodies[0].cavities.empty());
    EXPECT_EQ(bodies[1].cavities, std::vector<std::uint32_t>{2});
    EXPECT_TRUE(bodies[2].cavities.empty());
    EXPECT_NEAR(bodies[1].volume, enclosed_volume(icosphere(3, 10.0)) - enclosed_volume(icosphere(3, 8.0)),
                1e-6);
}

TEST(Bodies, the_largest_come_first_and_take_their_cavities_along)
{
    const SelectedBodies kept = select_bodies(nested(), {.keep_largest = 2}, true);
    ASSERT_EQ(kept.bodies.size(), 2U);
    EXPECT_EQ(count_components(kept.bodies[0]), 2U);
    EXPECT_EQ(count_components(kept.bodies[1]), 1U);
    EXPECT_EQ(kept.bodies_dropped, 1U);
    EXPECT_NEAR(kept.volume_dropped, enclosed_volume(icosphere(3, 3.0)), 1e-9);
}

TEST(Bodies, cavities_can_be_filled_and_small_bodies_left_out)
{
    const SelectedBodies kept = select_bodies(nested(), {.min_volume = 200.0, .drop_cavities = true}, false);
    ASSERT_EQ(kept.bodies.size(), 2U);
    EXPECT_EQ(kept.cavities_dropped, 1U);
    EXPECT_EQ(count_components(kept.bodies[0]), 1U);
}

} // namespace
} // namespace voroprobe
