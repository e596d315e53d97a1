#include "volume/trilinear_cell.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/random.h"

namespace voroprobe
{
namespace
{

CellCorners random_corners(Random& random)
{
    CellCorners corners;
    for (double& corner : corners)
        corner = random.uniform(-1.0, 1.0);
    return corners;
}

Vec3 random_local(Random& random)
{
    const double x = random.uniform();
    const double y = random.uniform();
    return {x, y, random.uniform()};
}

//! The cubic with leading coefficient `scale` and the given roots, by its values at 0, 1/3, 2/3, 1.
BernsteinCubic cubic_with_roots(double scale, double a, double b, double c)
{
    // Blossom of (w - a)(w - b)(w - c): the average over the ways to deal the arguments to the roots.
    const auto blossom = [&](double u, double v, double w)
    {
        return scale / 6.0 *
               ((u - a) * (v - b) * (w - c) + (u - a) * (w - b) * (v - c) + (v - a) * (u - b) * (w - c) +
                (v - a) * (w - b) * (u - c) + (w - a) * (u - b) * (v - c) + (w - a) * (v - b) * (u - c));
    };
    return {blossom(0, 0, 0), blossom(0, 0, 1), blossom(0, 1, 1), blossom(1, 1, 1)};
}

TEST(TrilinearCell, corners_keep_their_values_exactly)
{
    Random random(1);
    const CellCorners corners = random_corners(random);
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_EQ(trilinear_value(corners, {i & 1U ? 1.0 : 0.0, i & 2U ? 1.0 : 0.0, i & 4U ? 1.0 : 0.0}),
                  corners[i]);
}

TEST(TrilinearCell, a_face_has_the_same_value_from_both_sides_to_the_last_bit)
{
    Random random(2);
    for (int i = 0; i < 1000; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const std::size_t bit = std::size_t{1} << axis;
            const CellCorners low = random_corners(random);
            CellCorners high = random_corners(random);
            for (std::size_t c = 0; c < 8; ++c)
                if ((c & bit) == 0)
                    high[c] = low[c | bit];
            Vec3 p = random_local(random);
            p[axis] = 1.0;
            const double from_low = trilinear_value(low, p);
            p[axis] = 0.0;
            ASSERT_EQ(from_low, trilinear_value(high, p));
        }
}

TEST(TrilinearCell, corners_on_one_side_keep_the_interpolant_there)
{
    Random random(3);
    for (int i = 0; i < 10'000; ++i)
    {
        CellCorners corners;
        for (double& corner : corners)
            corner = std::pow(10.0, random.uniform(-12.0, 12.0));
        const Vec3 p = random_local(random);
        ASSERT_GT(trilinear_value(corners, p), 0.0);
        for (double& corner : corners)
            corner = -corner;
        ASSERT_LT(trilinear_value(corners, p), 0.0);
    }
}

TEST(TrilinearCell, the_cubic_is_the_interpolant_along_the_segment)
{
    Random random(4);
    for (int i = 0; i < 1000; ++i)
    {
        const CellCorners corners = random_corners(random);
        const Vec3 from = random_local(random);
        const Vec3 to = random_local(random);
        const BernsteinCubic b = restrict_to_segment(corners, from, to);
        ASSERT_EQ(b[0], trilinear_value(corners, from));
        ASSERT_EQ(b[3], trilinear_value(corners, to));
        for (const double w : {0.2, 0.5, 0.9})
        {
            const double v = 1.0 - w;
            const double value =
                v * v * v * b[0] + 3 * v * v * w * b[1] + 3 * v * w * w * b[2] + w * w * w * b[3];
            ASSERT_NEAR(value, trilinear_value(corners, from + w * (to - from)), 1e-14);
        }
    }
}

TEST(TrilinearCell, three_roots_are_found_where_they_were_put)
{
    Random random(5);
    for (int i = 0; i < 100'000; ++i)
    {
        std::array<double, 3> wanted{random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5),
                                     random.uniform(-0.5, 1.5)};
        std::sort(wanted.begin(), wanted.end());
        if (std::min(wanted[1] - wanted[0], wanted[2] - wanted[1]) < 1e-3)
            continue; // well apart, so that rounding moves the roots by no more than the tolerance below
        const double scale = random.below(2) == 0 ? 3.0 : -0.01;
        const CubicRoots roots = find_sign_changes(cubic_with_roots(scale, wanted[0], wanted[1], wanted[2]));
        std::vector<double> inside;
        std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(inside),
                     [](double w) { return w >= 0 && w <= 1; });
        ASSERT_EQ(roots.count, inside.size());
        for (std::size_t r = 0; r < inside.size(); ++r)
            ASSERT_NEAR(roots.parameter[r], inside[r], 1e-8);
    }
}

TEST(TrilinearCell, touching_zero_is_no_sign_change)
{
    const CubicRoots touching = find_sign_changes(cubic_with_roots(1.0, 0.5, 0.5, -0.25));
    EXPECT_EQ(touching.count, 0U);
    const CubicRoots just_crossing = find_sign_changes(cubic_with_roots(1.0, 0.5 - 1e-5, 0.5 + 1e-5, -0.25));
    EXPECT_EQ(just_crossing.count, 2U);
}

TEST(TrilinearCell, the_number_of_sign_changes_agrees_with_the_ends)
{
    // Coefficients of wildly different size, zeros among them.
    Random random(6);
    for (int i = 0; i < 300'000; ++i)
    {
        BernsteinCubic cubic;
        for (double& b : cubic)
            b = random.below(8) == 0 ? 0.0
                                     : random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-18.0, 3.0));
        const CubicRoots roots = find_sign_changes(cubic);
        ASSERT_EQ(roots.count % 2 == 1, (cubic[0] >= 0.0) != (cubic[3] >= 0.0));
        for (std::size_t r = 0; r < roots.count; ++r)
        {
            ASSERT_GE(roots.parameter[r], r == 0 ? 0.0 : roots.parameter[r - 1]);
            ASSERT_LE(roots.parameter[r], 1.0);
        }
    }
}

} // namespace
} // namespace voroprobe
