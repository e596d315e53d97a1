#include "cli/label_map.h"

#include <gtest/gtest.h>

#include "small_volume.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

bool looks_like_labels(const Volume& volume)
{
    return looks_like_label_map(volume, compute_statistics(volume));
}

Volume blocks_of_labels()
{
    return small_volume<std::uint16_t>({20, 10, 10}, [](std::size_t i, std::size_t j, std::size_t)
                                       { return static_cast<std::uint16_t>(j < 2 ? 0 : 1 + i / 4); });
}

TEST(LabelMap, blocks_of_equal_whole_numbers_are_one)
{
    EXPECT_TRUE(looks_like_labels(blocks_of_labels()));
    EXPECT_NEAR(equal_neighbor_share(blocks_of_labels()), 15.0 / 19.0, 0.05);
}

TEST(LabelMap, whole_numbers_with_noise_are_none)
{
    Random random(1);
    EXPECT_FALSE(looks_like_labels(
        small_volume<std::uint8_t>({20, 10, 10}, [&](std::size_t, std::size_t, std::size_t)
                                   { return static_cast<std::uint8_t>(random.below(64)); })));
}

TEST(LabelMap, fractions_are_none)
{
    EXPECT_FALSE(looks_like_labels(small_volume<float>({20, 10, 10},
                                                       [](std::size_t i, std::size_t, std::size_t)
                                                       {
                                                           const std::size_t block = i / 4;
                                                           return 0.5F * static_cast<float>(block);
                                                       })));
}

TEST(LabelMap, a_mask_of_two_values_is_none)
{
    EXPECT_FALSE(
        looks_like_labels(small_volume<std::uint8_t>({20, 10, 10}, [](std::size_t i, std::size_t, std::size_t)
                                                     { return static_cast<std::uint8_t>(i < 10 ? 0 : 1); })));
}

TEST(LabelMap, a_constant_volume_has_no_pairs_to_judge_by)
{
    const Volume constant = small_volume<std::uint8_t>({4, 4, 4}, [](std::size_t, std::size_t, std::size_t)
                                                       { return std::uint8_t{9}; });
    EXPECT_EQ(equal_neighbor_share(constant), 0.0);
    EXPECT_FALSE(looks_like_labels(constant));
}

TEST(LabelMap, many_values_with_noise_look_like_a_scan_and_blocks_do_not)
{
    Random random(2);
    const Volume noise = small_volume<std::int16_t>({20, 10, 10}, [&](std::size_t, std::size_t, std::size_t)
                                                    { return static_cast<std::int16_t>(random.below(900)); });
    EXPECT_TRUE(looks_like_scan(noise, 900));
    EXPECT_FALSE(looks_like_scan(noise, 20)); // soon meshed
    EXPECT_FALSE(looks_like_scan(blocks_of_labels(), 900));
}

} // namespace
} // namespace voroprobe
