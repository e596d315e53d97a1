#include "labels/part_presence.h"

#include <utility>

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"

namespace voroprobe
{

namespace
{

//! Two blocks of 3 voxels a side, 4 voxels apart: parts 1 and 2.
PartMask two_blocks()
{
    PartMask mask{.first = {0, 0, 0}, .size = {14, 7, 7}, .part = {}, .part_count = 2};
    for (std::size_t k = 0; k < 7; ++k)
        for (std::size_t j = 0; j < 7; ++j)
            for (std::size_t i = 0; i < 14; ++i)
            {
                const bool within = j >= 2 && j <= 4 && k >= 2 && k <= 4;
                mask.part.push_back(within && i >= 2 && i <= 4 ? 1U : within && i >= 9 && i <= 11 ? 2U : 0U);
            }
    return mask;
}

TriangleMesh ball_at(double x)
{
    TriangleMesh mesh;
    sample::append(mesh, sample::icosphere(2, 1.6), {x, 3, 3});
    return mesh;
}

using Present = std::vector<bool>;

TEST(PartPresence, each_part_is_there_where_a_closed_piece_lies_at_its_voxels)
{
    TriangleMesh both = ball_at(3);
    EXPECT_EQ(parts_present(both, two_blocks(), {1, 1, 1}), (Present{true, false}));
    EXPECT_EQ(parts_present(ball_at(10), two_blocks(), {1, 1, 1}), (Present{false, true}));
    sample::append(both, ball_at(10));
    EXPECT_EQ(parts_present(both, two_blocks(), {1, 1, 1}), (Present{true, true}));
    EXPECT_EQ(parts_present({}, two_blocks(), {1, 1, 1}), (Present{false, false}));
}

TEST(PartPresence, what_is_open_or_wound_inward_stands_for_nothing)
{
    TriangleMesh open = ball_at(3);
    open.faces.pop_back();
    EXPECT_EQ(parts_present(open, two_blocks(), {1, 1, 1}), (Present{false, false}));
    TriangleMesh inward = ball_at(3);
    for (TriangleMesh::Face& face : inward.faces)
        std::swap(face[0], face[1]);
    EXPECT_EQ(parts_present(inward, two_blocks(), {1, 1, 1}), (Present{false, false}));
}

TEST(PartPresence, one_piece_is_one_part)
{
    // A dumbbell: the bridge leaves both balls on one piece, and the larger part of it is at the first.
    TriangleMesh ball = ball_at(3);
    for (Point3& p : ball.vertices)
        if (p.x > 4.0)
            p.x += 7.0;
    EXPECT_EQ(parts_present(ball, two_blocks(), {1, 1, 1}), (Present{true, false}));
}

} // namespace

} // namespace voroprobe
