#include "volume/cell_topology.h"

#include <gtest/gtest.h>

#include "cell_slices.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

//! Corners with the sides of `code`; magnitudes spread over some powers of two, as saddles depend on ratios.
CellCorners random_corners(Random& random, unsigned code)
{
    CellCorners corners;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
        const double magnitude = std::exp2(random.uniform(-6.0, 6.0));
        corners[corner] = (code >> corner & 1U) != 0 ? magnitude : -magnitude;
    }
    return corners;
}

//! Integers from -4 to 4 but 0: saddles of value 0 abound.
CellCorners random_integer_corners(Random& random, unsigned code)
{
    CellCorners corners;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
        const double magnitude = 1.0 + static_cast<double>(random.below(4));
        corners[corner] = (code >> corner & 1U) != 0 ? magnitude : -magnitude;
    }
    return corners;
}

//! In general position, and with every saddle of value 0 inside: the same regions.
CellCorners raised(Random& random, CellCorners corners)
{
    for (double& height : corners)
        height += 1e-9 * random.uniform(1.0, 2.0);
    return corners;
}

//! Parts named by their smallest corners, as the reference does.
CornerParts by_smallest(const CornerParts& parts)
{
    CornerParts named = parts;
    for (std::size_t corner = 0; corner < 8; ++corner)
        for (std::size_t other = 8; other-- > 0;)
            if (parts[other] == parts[corner])
                named[corner] = static_cast<std::uint8_t>(other);
    return named;
}

int count_parts(const CornerParts& parts)
{
    int count = 0;
    for (std::size_t corner = 0; corner < 8; ++corner)
        count += by_smallest(parts)[corner] == corner ? 1 : 0;
    return count;
}

std::string text(const CellCorners& corners)
{
    std::string text;
    for (const double height : corners)
        text += std::to_string(height) + " ";
    return text;
}

Vec3 random_local(Random& random)
{
    const double x = random.uniform();
    const double y = random.uniform();
    return {x, y, random.uniform()};
}

TEST(CellTopology, parts_are_those_of_the_interpolant_for_all_sign_patterns)
{
    Random random(1);
    for (unsigned code = 0; code < 256; ++code)
        for (int i = 0; i < 1000; ++i)
        {
            const CellCorners corners = random_corners(random, code);
            ASSERT_EQ(by_smallest(connect_corners(corners).in_cell), CellSlices(corners).parts())
                << "corners " << text(corners);
        }
}

TEST(CellTopology, saddles_of_value_0_are_inside)
{
    Random random(2);
    for (unsigned code = 0; code < 256; ++code)
        for (int i = 0; i < 1000; ++i)
        {
            const CellCorners corners = random_integer_corners(random, code);
            ASSERT_EQ(by_smallest(connect_corners(corners).in_cell),
                      CellSlices(raised(random, corners)).parts())
                << "corners " << text(corners);
        }
}

TEST(CellTopology, body_saddles_join_what_faces_leave_apart)
{
    // Opposite corners inside and a middle inside: (2 + 2 - 6 * 0.5) / 8 > 0, while no face is ambiguous.
    const CellCorners corners{2, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, 2};
    const CellTopology topology = connect_corners(corners);
    EXPECT_NE(topology.on_faces[0], topology.on_faces[7]);
    EXPECT_EQ(topology.in_cell[0], topology.in_cell[7]);
    EXPECT_EQ(connect_corners_on_faces(corners).in_cell, topology.on_faces);
}

TEST(CellTopology, joins_through_the_body_are_met_often_by_the_random_cells)
{
    Random random(3);
    int joined = 0;
    for (unsigned code = 0; code < 256; ++code)
        for (int i = 0; i < 20; ++i)
        {
            const CellTopology topology = connect_corners(random_corners(random, code));
            joined += topology.in_cell != topology.on_faces ? 1 : 0;
        }
    EXPECT_GT(joined, 20);
}

TEST(CellTopology, patches_are_spheres_with_holes)
{
    // The surface in the open grid cell: 2 for each patch, -1 for each loop. Both are edges of trees: of the
    // parts in the grid cell, and of the parts on its faces.
    Random random(4);
    for (unsigned code = 1; code < 255; ++code)
        for (int i = 0; i < 200; ++i)
        {
            const CellCorners corners = random_corners(random, code);
            const CellTopology topology = connect_corners(corners);
            const int patches = count_parts(topology.in_cell) - 1;
            const int loops = count_parts(topology.on_faces) - 1;
            ASSERT_EQ(2 * patches - loops, CellSlices(corners).surface_euler_characteristic())
                << "corners " << text(corners);
        }
}

TEST(CellTopology, the_way_to_a_corner_never_changes_side)
{
    Random random(5);
    for (unsigned code = 0; code < 256; ++code)
        for (int i = 0; i < 500; ++i)
        {
            const CellCorners corners = random_corners(random, code);
            const Vec3 local = random_local(random);
            const double value = trilinear_value(corners, local);
            const std::size_t up = corner_uphill(corners, local);
            const std::size_t down = corner_downhill(corners, local);
            const double rounding = 1e-12 * std::exp2(6.0);
            ASSERT_GE(corners[up], value - rounding);
            ASSERT_LE(corners[down], value + rounding);
            ASSERT_GE(corners[value >= 0.0 ? up : down] * value, 0.0);
        }
}

TEST(CellTopology, points_joined_by_a_segment_on_one_side_reach_the_same_part)
{
    Random random(6);
    for (unsigned code = 0; code < 256; ++code)
        for (int i = 0; i < 500; ++i)
        {
            const CellCorners corners = random_corners(random, code);
            const Vec3 from = random_local(random);
            const Vec3 to = random_local(random);
            const BernsteinCubic cubic = restrict_to_segment(corners, from, to);
            if (find_sign_changes(cubic).count != 0)
                continue;
            const auto corner = [&](const Vec3& p)
            { return cubic[0] >= 0.0 ? corner_uphill(corners, p) : corner_downhill(corners, p); };
            const CornerParts parts = connect_corners(corners).in_cell;
            ASSERT_EQ(parts[corner(from)], parts[corner(to)]) << "corners " << text(corners);
        }
}

TEST(CellTopology, the_table_agrees_with_the_connections_it_stands_for)
{
    Random random(7);
    for (unsigned code = 0; code < 256; ++code)
    {
        const CodeTopology& table = topology_of(static_cast<CornerCode>(code));
        EXPECT_TRUE(code == 0 || (code >> table.an_inside & 1U) != 0);
        EXPECT_TRUE(code == 255 || (code >> table.an_outside & 1U) == 0);
        for (int i = 0; table.simple && i < 20; ++i)
        {
            const CellTopology topology = connect_corners(random_corners(random, code));
            EXPECT_EQ(topology.on_faces, topology.in_cell);
            EXPECT_LE(count_parts(topology.in_cell), 2);
        }
    }
}

} // namespace
} // namespace voroprobe
