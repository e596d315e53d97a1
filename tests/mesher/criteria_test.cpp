#include "mesher/criteria.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace voroprobe
{
namespace
{

constexpr MeshingOptions kOptions{
    .max_facet_radius = 2.0, .max_facet_distance = 0.5, .floor_radius = 0.1, .reach_lower_bound = 1.0};

//! A facet with its corners on a circle about the origin, and its ball center `height` above the circle's.
struct HandMade
{
    RestrictedFacet facet;
    std::array<Point3, 3> corners;
};

HandMade make(double circumradius, double height, const std::array<double, 3>& corners_deg,
              std::uint8_t crossings = 1)
{
    HandMade made;
    made.facet.center = {0, 0, height};
    made.facet.squared_radius = circumradius * circumradius + height * height;
    made.facet.crossing_count = crossings;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const double angle = corners_deg[i] * std::numbers::pi / 180.0;
        made.corners[i] = {circumradius * std::cos(angle), circumradius * std::sin(angle), 0.0};
    }
    return made;
}

constexpr std::array<double, 3> kEquilateral{0, 120, 240};

std::optional<Badness> badness(const HandMade& made, const MeshingOptions& options = kOptions)
{
    return FacetCriteria(options).badness(made.facet, made.corners);
}

TEST(FacetCriteria, a_good_facet_is_not_bad)
{
    EXPECT_EQ(badness(make(1.0, 0.1, kEquilateral)), std::nullopt);
}

TEST(FacetCriteria, size_bounds_the_radius_of_the_ball)
{
    EXPECT_EQ(badness(make(1.999, 0.0, kEquilateral)), std::nullopt);
    EXPECT_EQ(badness(make(2.001, 0.0, kEquilateral)), Badness::kSize);
}

TEST(FacetCriteria, distance_bounds_the_height_of_the_ball_center)
{
    EXPECT_EQ(badness(make(1.0, 0.499, kEquilateral)), std::nullopt);
    EXPECT_EQ(badness(make(1.0, 0.501, kEquilateral)), Badness::kDistance);
    MeshingOptions without = kOptions;
    without.max_facet_distance.reset();
    EXPECT_EQ(badness(make(1.0, 0.501, kEquilateral), without), std::nullopt);
}

TEST(FacetCriteria, angle_bounds_the_smallest_angle)
{
    // Corners 2 a apart on the circle see each other under the angle a.
    EXPECT_EQ(badness(make(1.0, 0.0, {0, 60.1, 200})), std::nullopt);
    EXPECT_EQ(badness(make(1.0, 0.0, {0, 59.9, 200})), Badness::kAngle);
    EXPECT_EQ(badness(make(1.0, 0.0, {200, 0, 59.9})), Badness::kAngle);
    EXPECT_EQ(badness(make(1.0, 0.0, {0, 30, 60.1})), Badness::kAngle);
    MeshingOptions lenient = kOptions;
    lenient.min_facet_angle_deg = 20.0;
    EXPECT_EQ(badness(make(1.0, 0.0, {0, 40.1, 200}), lenient), std::nullopt);
    EXPECT_EQ(badness(make(1.0, 0.0, {0, 39.9, 200}), lenient), Badness::kAngle);
}

TEST(FacetCriteria, what_is_coarser_is_named_first)
{
    EXPECT_EQ(badness(make(3.0, 1.0, {0, 10, 20}, 3)), Badness::kSize);
    EXPECT_EQ(badness(make(1.0, 1.0, {0, 10, 20}, 3)), Badness::kDistance);
    EXPECT_EQ(badness(make(1.0, 0.0, {0, 10, 20}, 3)), Badness::kAngle);
    EXPECT_EQ(badness(make(1.0, 0.0, kEquilateral, 3)), Badness::kUnresolved);
}

TEST(FacetCriteria, even_facets_are_evidence_and_their_shape_plays_no_part)
{
    EXPECT_EQ(badness(make(3.0, 1.0, {0, 10, 20}, 2)), Badness::kUnresolved);
}

TEST(FacetCriteria, unresolved_facets_are_refined_down_to_the_floor)
{
    EXPECT_EQ(badness(make(0.101, 0.0, kEquilateral, 2)), Badness::kUnresolved);
    EXPECT_EQ(badness(make(0.099, 0.0, kEquilateral, 2)), std::nullopt);
    EXPECT_FALSE(FacetCriteria(kOptions).at_floor(make(0.101, 0.0, kEquilateral).facet));
    EXPECT_TRUE(FacetCriteria(kOptions).at_floor(make(0.099, 0.0, kEquilateral).facet));
}

TEST(FacetCriteria, the_angle_is_refined_below_the_floor_but_not_for_ever)
{
    EXPECT_EQ(badness(make(0.05, 0.0, {0, 50, 200})), Badness::kAngle);
    EXPECT_EQ(badness(make(1e-4, 0.0, {0, 50, 200})), std::nullopt);
}

} // namespace
} // namespace voroprobe
