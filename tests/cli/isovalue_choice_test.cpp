#include "cli/isovalue_choice.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "small_volume.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

//! Dark and bright halves with slopes, so that neighbours differ.
Volume two_halves()
{
    return small_volume<float>({8, 4, 4},
                               [](std::size_t i, std::size_t j, std::size_t k)
                               {
                                   return static_cast<float>((i < 4 ? 0.0 : 100.0) + static_cast<double>(i) +
                                                             0.1 * static_cast<double>(j + 4 * k));
                               });
}

IsovalueChoice choose(const Volume& volume, std::optional<double> asked, InsideIs inside = InsideIs::kAbove)
{
    return choose_isovalue(asked, inside, volume, compute_statistics(volume));
}

TEST(IsovalueChoice, automatic_separates_two_clusters)
{
    const IsovalueChoice choice = choose(two_halves(), std::nullopt);
    EXPECT_GT(choice.value, 4.9);
    EXPECT_LE(choice.value, 104.0);
    EXPECT_EQ(choice.source, "Otsu");
    EXPECT_DOUBLE_EQ(share_inside(two_halves(), choice.value, InsideIs::kAbove), 0.5);
}

TEST(IsovalueChoice, a_mask_is_cut_halfway)
{
    const Volume mask = small_volume<std::uint8_t>({6, 6, 6}, [](std::size_t i, std::size_t, std::size_t)
                                                   { return static_cast<std::uint8_t>(i < 3 ? 0 : 255); });
    EXPECT_DOUBLE_EQ(choose(mask, std::nullopt).value, 127.5);
}

TEST(IsovalueChoice, a_value_beyond_the_samples_is_refused_with_one_that_works)
{
    const Volume volume = two_halves();
    for (const double beyond : {-1.0, 1000.0})
    {
        try
        {
            choose(volume, beyond);
            FAIL() << beyond << " was taken";
        }
        catch (const EmptySurfaceError& error)
        {
            const std::string message = error.what();
            EXPECT_NE(message.find("range from 0 to 108.5"), std::string::npos) << message;
            EXPECT_NE(message.find("try --isovalue " /* and a number */), std::string::npos) << message;
        }
    }
}

TEST(IsovalueChoice, the_ends_of_the_range_follow_the_inside_rule)
{
    EXPECT_FALSE(separates(0.0, InsideIs::kAbove, 0.0, 10.0)); // every sample is inside
    EXPECT_TRUE(separates(10.0, InsideIs::kAbove, 0.0, 10.0)); // the largest samples alone are
    EXPECT_TRUE(separates(0.0, InsideIs::kBelow, 0.0, 10.0));
    EXPECT_FALSE(separates(10.0, InsideIs::kBelow, 0.0, 10.0));
}

TEST(IsovalueChoice, nothing_separates_equal_or_missing_samples)
{
    const auto volume_of = [](float value) {
        return small_volume<float>({3, 3, 3}, [=](std::size_t, std::size_t, std::size_t) { return value; });
    };
    EXPECT_THROW(choose(volume_of(7.0F), std::nullopt), EmptySurfaceError);
    EXPECT_THROW(choose(volume_of(7.0F), 7.0), EmptySurfaceError);
    EXPECT_THROW(choose(volume_of(std::numeric_limits<float>::quiet_NaN()), std::nullopt), EmptySurfaceError);
    EXPECT_THROW(choose(volume_of(std::numeric_limits<float>::quiet_NaN()), 1.0), EmptySurfaceError);
}

TEST(IsovalueChoice, a_label_map_needs_one_given)
{
    const Volume labels = small_volume<std::uint8_t>({12, 6, 6}, [](std::size_t i, std::size_t, std::size_t)
                                                     { return static_cast<std::uint8_t>(i / 3); });
    EXPECT_THROW(choose(labels, std::nullopt), UsageError);
    EXPECT_EQ(choose(labels, 0.5).value, 0.5);
}

TEST(IsovalueChoice, samples_that_are_not_finite_are_outside)
{
    const auto infinite = std::numeric_limits<float>::infinity();
    const Volume volume =
        small_volume<float>({4, 1, 1},
                            [=](std::size_t i, std::size_t, std::size_t) {
                                return i == 0 ? infinite : i == 1 ? -infinite : static_cast<float>(i);
                            });
    EXPECT_DOUBLE_EQ(share_inside(volume, 2.5, InsideIs::kAbove), 0.25);
    EXPECT_DOUBLE_EQ(share_inside(volume, 2.5, InsideIs::kBelow), 0.25);
}

TEST(IsovalueChoice, border_share_looks_at_the_six_faces_only)
{
    const auto core = [](std::size_t i, std::size_t j, std::size_t k)
    { return i > 0 && i < 4 && j > 0 && j < 4 && k > 0 && k < 4; };
    const Volume volume = small_volume<float>({5, 5, 5}, [&](std::size_t i, std::size_t j, std::size_t k)
                                              { return core(i, j, k) ? 1.0F : 0.0F; });
    EXPECT_DOUBLE_EQ(border_share_inside(volume, 0.5, InsideIs::kAbove), 0.0);
    EXPECT_DOUBLE_EQ(border_share_inside(volume, 0.5, InsideIs::kBelow), 1.0);
}

} // namespace
} // namespace voroprobe
