#include "oracles/sphere_union_oracle.h"

#include <limits>

#include "oracle_laws.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

SphereUnionOracle shells_and_a_speck()
{
    return SphereUnionOracle({{{0, 0, 0}, 10.0}, {{0, 0, 0}, 4.0}, {{1, 0, 0}, 2.0}, {{20, 0, 0}, 0.5}});
}

TEST(SphereUnionOracle, a_segment_through_every_sphere_crosses_each_twice_in_order)
{
    std::vector<Crossing> crossings;
    shells_and_a_speck().find_crossings({{-100, 0, 0}, {100, 0, 0}}, crossings);

    const std::vector<double> x{-10, -4, -1, 3, 4, 10, 19.5, 20.5};
    ASSERT_EQ(crossings.size(), x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        EXPECT_NEAR(crossings[i].point.x, x[i], 1e-12);
}

TEST(SphereUnionOracle, a_short_segment_across_a_speck_is_seen)
{
    std::vector<Crossing> crossings;
    shells_and_a_speck().find_crossings({{20, -0.6, 0}, {20, 0.6, 0}}, crossings);
    EXPECT_EQ(crossings.size(), 2U);
}

TEST(SphereUnionOracle, a_tangent_segment_does_not_cross)
{
    std::vector<Crossing> crossings;
    shells_and_a_speck().find_crossings({{-5, 10, 0}, {5, 10, 0}}, crossings);
    EXPECT_TRUE(crossings.empty());
}

TEST(SphereUnionOracle, regions_alternate_through_nested_spheres)
{
    const SphereUnionOracle oracle = shells_and_a_speck();
    EXPECT_TRUE(is_inside(oracle.region({7, 0, 0})));
    EXPECT_FALSE(is_inside(oracle.region({-3, 0, 0})));
    EXPECT_TRUE(is_inside(oracle.region({1, 0, 0})));
    EXPECT_EQ(oracle.region({1000, 0, 0}), kOuterRegion);
    EXPECT_EQ(oracle.region({std::numeric_limits<double>::quiet_NaN(), 0, 0}), kOuterRegion);
}

TEST(SphereUnionOracle, keeps_the_laws_of_oracles)
{
    expect_laws_on_random_segments(shells_and_a_speck(), 1, 20'000);
}

TEST(SphereUnionOracle, may_cross_tells_the_surface_from_the_inside_and_the_outside)
{
    const SphereUnionOracle oracle({{{0, 0, 0}, 10.0}});
    EXPECT_TRUE(oracle.may_cross({{9, -1, -1}, {11, 1, 1}}));
    EXPECT_FALSE(oracle.may_cross({{-1, -1, -1}, {1, 1, 1}}));
    EXPECT_FALSE(oracle.may_cross({{9, 9, 9}, {11, 11, 11}}));
    EXPECT_TRUE(oracle.may_cross({{-20, -20, -20}, {20, 20, 20}}));
}

TEST(SphereUnionOracle, refuses_spheres_that_make_no_surface)
{
    EXPECT_THROW(SphereUnionOracle({}), UsageError);
    EXPECT_THROW(SphereUnionOracle({{{0, 0, 0}, 0.0}}), UsageError);
    EXPECT_THROW(SphereUnionOracle({{{0, 0, 0}, 2.0}, {{3, 0, 0}, 2.0}}), UsageError);
    EXPECT_THROW(SphereUnionOracle({{{0, 0, 0}, 2.0}}, -1.0), UsageError);
}

} // namespace
} // namespace voroprobe
