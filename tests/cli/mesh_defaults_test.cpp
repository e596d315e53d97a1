#include "cli/mesh_defaults.h"

#include <gtest/gtest.h>

#include "support/error.h"

namespace voroprobe
{
namespace
{

AffineTransform index_from_grid(const Vec3& spacing)
{
    return {{{Vec3{1 / spacing.x, 0, 0}, Vec3{0, 1 / spacing.y, 0}, Vec3{0, 0, 1 / spacing.z}}}, {5, -3, 0}};
}

TEST(VoxelScale, is_read_off_the_map_to_index_coordinates)
{
    const VoxelScale scale = voxel_scale(index_from_grid({0.5, 0.25, 8.0}));
    EXPECT_DOUBLE_EQ(scale.shortest_side, 0.25);
    EXPECT_DOUBLE_EQ(scale.mean_side, 1.0);
}

TEST(VoxelScale, does_not_change_when_axes_are_permuted_and_flipped)
{
    const AffineTransform permuted{{{Vec3{0, -2, 0}, Vec3{0, 0, 4}, Vec3{0.125, 0, 0}}}, {0, 0, 0}};
    EXPECT_DOUBLE_EQ(voxel_scale(permuted).shortest_side, 0.25);
    EXPECT_DOUBLE_EQ(voxel_scale(permuted).mean_side, 1.0);
}

TEST(MeshDefaults, follow_the_voxel)
{
    const MeshingOptions options = meshing_options({}, {.shortest_side = 0.5, .mean_side = 1.0});
    EXPECT_DOUBLE_EQ(options.max_facet_radius, 2.0);
    EXPECT_DOUBLE_EQ(options.max_facet_distance.value(), 0.15);
    EXPECT_DOUBLE_EQ(options.floor_radius, 0.125);
    EXPECT_DOUBLE_EQ(options.reach_lower_bound, 0.5);
    EXPECT_DOUBLE_EQ(options.min_facet_angle_deg, 30.0);
}

TEST(MeshDefaults, give_way_to_every_value_asked_for)
{
    const RequestedCriteria requested{
        .size = 3.0, .distance = 0.7, .floor = 0.2, .reach = 0.9, .angle_deg = 20.0};
    const MeshingOptions options = meshing_options(requested, {.shortest_side = 1.0, .mean_side = 1.0});
    EXPECT_EQ(options.max_facet_radius, 3.0);
    EXPECT_EQ(options.max_facet_distance.value(), 0.7);
    EXPECT_EQ(options.floor_radius, 0.2);
    EXPECT_EQ(options.reach_lower_bound, 0.9);
    EXPECT_EQ(options.min_facet_angle_deg, 20.0);
}

TEST(MeshDefaults, keep_the_floor_below_a_small_size)
{
    const MeshingOptions options = meshing_options({.size = 0.1}, {.shortest_side = 1.0, .mean_side = 1.0});
    EXPECT_DOUBLE_EQ(options.floor_radius, 0.05);
}

TEST(MeshDefaults, refuse_a_floor_above_the_size)
{
    const RequestedCriteria requested{.size = 1.0, .floor = 1.5};
    EXPECT_THROW(meshing_options(requested, {.shortest_side = 1.0, .mean_side = 1.0}), UsageError);
}

} // namespace
} // namespace voroprobe
