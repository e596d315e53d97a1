#include "oracles/implicit_oracle.h"

#include <cmath>
#include <limits>

#include "oracle_laws.h"
#include "oracles/sphere_union_oracle.h"
#include "support/error.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

constexpr double kResolution = 1e-3;
const Box3 kCube{{-3, -3, -3}, {3, 3, 3}};

TEST(ImplicitOracle, finds_the_crossings_of_nested_shells_in_closed_form)
{
    const ImplicitOracle oracle(nested_shells_phantom({0, 0, 0}, {2.0, 1.0, 0.4}), kCube, 1.0, kResolution);
    const SphereUnionOracle truth({{{0, 0, 0}, 2.0}, {{0, 0, 0}, 1.0}, {{0, 0, 0}, 0.4}});
    Random random(2);
    std::vector<Crossing> crossings;
    std::vector<Crossing> expected;
    int passed_over = 0;
    for (int i = 0; i < 2000; ++i)
    {
        const Segment3 segment = random_segment(random, kCube.expanded(2.0));
        oracle.find_crossings(segment, crossings);
        truth.find_crossings(segment, expected);
        if (expected.size() != crossings.size())
        {
            ++passed_over;
            continue;
        }
        for (std::size_t c = 0; c < crossings.size(); ++c)
            ASSERT_NEAR(distance(crossings[c].point, expected[c].point), 0.0, 1e-9);
    }
    EXPECT_LE(passed_over, 2) << "only a chord shorter than the resolution may be passed over";
}

TEST(ImplicitOracle, sees_two_sheets_a_few_resolutions_apart)
{
    const auto sheet = [](const Point3& p) { return 2.0 * kResolution - std::abs(p.x - 0.123); };
    const ImplicitOracle oracle(sheet, kCube, 1.0, kResolution);
    std::vector<Crossing> crossings;
    oracle.find_crossings({{-2, 0, 0}, {2, 1, 0}}, crossings);
    ASSERT_EQ(crossings.size(), 2U);
    EXPECT_NEAR(crossings[0].point.x, 0.121, 1e-10);
    EXPECT_NEAR(crossings[1].point.x, 0.125, 1e-10);
}

TEST(ImplicitOracle, an_object_that_leaves_the_domain_is_capped)
{
    const ImplicitOracle oracle([](const Point3& p) { return 1.0 - p.z; }, kCube, 1.0, kResolution);
    std::vector<Crossing> crossings;
    oracle.find_crossings({{0, 0, -10}, {0, 0, 10}}, crossings);
    ASSERT_EQ(crossings.size(), 2U);
    EXPECT_TRUE(crossings[0].on_border);
    EXPECT_NEAR(crossings[0].point.z, -3.0, 1e-12);
    EXPECT_FALSE(crossings[1].on_border);
    EXPECT_NEAR(crossings[1].point.z, 1.0, 1e-10);
    EXPECT_TRUE(oracle.may_cross({{-4, 0, 0}, {-2.5, 0.1, 0.1}}));
    EXPECT_FALSE(oracle.may_cross({{-2.5, 0, 0}, {-2.4, 0.1, 0.1}}));
    EXPECT_FALSE(oracle.may_cross({{-4, 0, 1.5}, {-2.5, 0.1, 3.0}}));
}

TEST(ImplicitOracle, nan_is_outside)
{
    const auto half_defined = [](const Point3& p) { return p.x < 0.0 ? 1.0 - norm(p) : std::nan(""); };
    const ImplicitOracle oracle(half_defined, kCube, 1.0, kResolution);
    EXPECT_EQ(oracle.region({0.5, 0, 0}), kOuterRegion);
    std::vector<Crossing> crossings;
    oracle.find_crossings({{-2, 0, 0}, {2, 0, 0}}, crossings);
    ASSERT_EQ(crossings.size(), 2U);
    EXPECT_NEAR(crossings[1].point.x, 0.0, kResolution);
}

TEST(ImplicitOracle, keeps_the_laws_of_oracles)
{
    const Box3 box{{-1.2, -0.8, -0.5}, {1.2, 0.8, 0.5}};
    expect_laws_on_random_segments(
        ImplicitOracle(double_torus_phantom({0, 0, 0}, 1.0), box, 13.0, kResolution), 3, 2000);
    const Box3 unit{{-1, -1, -1}, {1, 1, 1}};
    expect_laws_on_random_segments(
        ImplicitOracle(marschner_lobb_phantom({0, 0, 0}, 1.0), unit, 6.0, kResolution), 4, 2000);
}

TEST(ImplicitOracle, refuses_arguments_outside_their_range)
{
    const auto sphere = sphere_phantom({0, 0, 0}, 1.0);
    EXPECT_THROW(ImplicitOracle(nullptr, kCube, 1.0, kResolution), UsageError);
    EXPECT_THROW(ImplicitOracle(sphere, Box3{}, 1.0, kResolution), UsageError);
    EXPECT_THROW(ImplicitOracle(sphere, kCube, 0.0, kResolution), UsageError);
    EXPECT_THROW(ImplicitOracle(sphere, kCube, 1.0, std::numeric_limits<double>::quiet_NaN()), UsageError);
}

} // namespace
} // namespace voroprobe
