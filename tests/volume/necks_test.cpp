#include "volume/necks.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

using Index = std::array<long, 3>;

//! The necks of a scan whose heights are given sample by sample, 1 mm apart.
template <class Height>
std::vector<Neck> necks_of(const std::array<std::size_t, 3>& size, Height height)
{
    const auto at_point = [&](const Point3& p) {
        return height(Index{std::lround(p.x), std::lround(p.y), std::lround(p.z)});
    };
    const auto volume = std::make_shared<Volume>(sample_volume(at_point, size, {1, 1, 1}));
    const auto field = make_height_field(level_volume(volume, 0.0));
    return find_necks(*field, Inventory(*field, 1));
}

//! Those between samples.
std::vector<Neck> saddles(std::vector<Neck> necks)
{
    std::erase_if(necks,
                  [](const Neck& neck)
                  {
                      return neck.middle.x == std::round(neck.middle.x) &&
                             neck.middle.y == std::round(neck.middle.y) &&
                             neck.middle.z == std::round(neck.middle.z);
                  });
    return necks;
}

bool has_end(const Neck& neck, const Point3& end)
{
    return std::find(neck.ends.begin(), neck.ends.end(), end) != neck.ends.end();
}

TEST(Necks, a_saddle_inside_joins_its_corners)
{
    const auto necks = saddles(necks_of({4, 4, 4},
                                        [](const Index& s) {
                                            return s == Index{1, 1, 1} || s == Index{2, 2, 1} ? 3.0 : -1.0;
                                        }));
    ASSERT_EQ(necks.size(), 1U);
    EXPECT_EQ(necks[0].middle, (Point3{1.5, 1.5, 1.0}));
    EXPECT_TRUE(is_inside(necks[0].region));
    EXPECT_EQ(necks[0].ends.size(), 2U);
    EXPECT_TRUE(has_end(necks[0], {1, 1, 1}));
    EXPECT_TRUE(has_end(necks[0], {2, 2, 1}));
    EXPECT_EQ(necks[0].surfaces.size(), 1U);
}

TEST(Necks, a_saddle_outside_passes_between_two_surfaces)
{
    const auto necks = saddles(necks_of({4, 4, 4},
                                        [](const Index& s) {
                                            return s == Index{1, 1, 1} || s == Index{2, 2, 1} ? 1.0 : -3.0;
                                        }));
    ASSERT_EQ(necks.size(), 1U);
    EXPECT_EQ(necks[0].region, kOuterRegion);
    EXPECT_TRUE(has_end(necks[0], {2, 1, 1}));
    EXPECT_TRUE(has_end(necks[0], {1, 2, 1}));
    EXPECT_EQ(necks[0].surfaces.size(), 2U);
}

TEST(Necks, a_saddle_lies_nearer_to_the_corner_that_is_less_deep)
{
    const auto necks =
        saddles(necks_of({4, 4, 4},
                         [](const Index& s) {
                             return s == Index{1, 1, 1} ? 1.0 : s == Index{2, 2, 1} ? 5.0 : -1.0;
                         }));
    ASSERT_EQ(necks.size(), 1U);
    EXPECT_EQ(necks[0].middle, (Point3{1.25, 1.25, 1.0})); // (1 + 1) / (1 + 5 + 1 + 1)
}

TEST(Necks, a_sample_between_two_blocks_is_a_bridge)
{
    const auto necks = necks_of({9, 5, 5},
                                [](const Index& s)
                                {
                                    const bool in_blocks = s[0] >= 1 && s[0] <= 7 && s[0] != 4 && s[1] >= 1 &&
                                                           s[1] <= 3 && s[2] >= 1 && s[2] <= 3;
                                    return in_blocks || s == Index{4, 2, 2} ? 1.0 : -1.0;
                                });
    const auto bridge = std::find_if(necks.begin(), necks.end(),
                                     [](const Neck& neck) {
                                         return neck.middle == Point3{4, 2, 2} && neck.ends.size() == 2;
                                     });
    ASSERT_NE(bridge, necks.end());
    EXPECT_TRUE(is_inside(bridge->region));
    EXPECT_TRUE(has_end(*bridge, {3, 2, 2}));
    EXPECT_TRUE(has_end(*bridge, {5, 2, 2}));
}

TEST(Necks, a_wall_one_sample_thick_has_necks_and_a_thick_one_none)
{
    const auto wall = [](long thickness)
    {
        return necks_of({8, 6, 6}, [thickness](const Index& s)
                        { return s[0] >= 3 && s[0] < 3 + thickness ? 1.0 : -1.0; });
    };
    const auto parts_two_sides = [](const Neck& neck) { return neck.middle == Point3{3, 2, 2}; };
    const auto thin = wall(1);
    EXPECT_TRUE(std::any_of(thin.begin(), thin.end(), parts_two_sides));
    EXPECT_TRUE(wall(2).empty());
}

TEST(Necks, a_ball_has_none)
{
    const LevelFunction ball = [](const Point3& p) { return 4.3 - distance(p, {6.1, 6.2, 6.3}); };
    const auto volume = std::make_shared<Volume>(sample_volume(ball, {13, 13, 13}, {1, 1, 1}));
    const auto field = make_height_field(level_volume(volume, 0.0));
    EXPECT_TRUE(find_necks(*field, Inventory(*field, 1)).empty());
}

} // namespace
} // namespace voroprobe
