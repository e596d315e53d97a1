#include "cli/output_frame.h"

#include <gtest/gtest.h>

namespace voroprobe
{
namespace
{

const GridPlacement kPlacement{
    .world_from_grid = {{}, {10, 20, 30}},
    .source_index_from_grid = {{{Vec3{-2, 0, 0}, Vec3{0, 2, 0}, Vec3{0, 0, 1}}}, {7, 0, 0}}};

TEST(OutputFrame, lps_is_the_world)
{
    EXPECT_EQ(output_from_grid(OutputFrame::kLps, kPlacement) * (Point3{1, 2, 3}), (Point3{11, 22, 33}));
}

TEST(OutputFrame, ras_turns_the_world_half_around_the_head_axis)
{
    EXPECT_EQ(output_from_grid(OutputFrame::kRas, kPlacement) * (Point3{1, 2, 3}), (Point3{-11, -22, 33}));
    EXPECT_GT(determinant(output_from_grid(OutputFrame::kRas, kPlacement).linear), 0.0);
}

TEST(OutputFrame, index_is_the_file_s_own)
{
    EXPECT_EQ(output_from_grid(OutputFrame::kIndex, kPlacement) * (Point3{1, 2, 3}), (Point3{5, 4, 3}));
    EXPECT_EQ(frame_unit(OutputFrame::kIndex), "voxel");
}

} // namespace
} // namespace voroprobe
