#include "volume/height_field.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/error.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

std::shared_ptr<Volume> volume_of(SampleArray samples, const std::array<std::size_t, 3>& size = {2, 2, 2})
{
    auto volume =
        std::make_shared<Volume>(sample_volume([](const Point3&) { return 0.0; }, size, {1.0, 2.0, 3.0}));
    volume->samples = std::move(samples);
    return volume;
}

std::vector<double> slice(const HeightField& field, std::size_t k)
{
    std::vector<double> heights(static_cast<std::size_t>(field.frame().sample_count[0]) *
                                static_cast<std::size_t>(field.frame().sample_count[1]));
    field.read_slice(k, heights);
    return heights;
}

TEST(HeightField, samples_beyond_all_measure_are_refused)
{
    const double most = std::numeric_limits<double>::max();
    for (const double extreme : {most, -most, 1e61})
        EXPECT_THROW(level_volume(volume_of(std::vector<double>{0, 1, 2, 3, 4, 5, 6, extreme}), 2.5),
                     InputError);
    const float most_of_float = std::numeric_limits<float>::max();
    EXPECT_NO_THROW(
        level_volume(volume_of(std::vector<float>{0, 1, 2, 3, 4, 5, most_of_float, -most_of_float}), 2.5));
}

TEST(HeightField, is_the_difference_from_the_isovalue_in_every_sample_type)
{
    for (const SampleArray& samples : {SampleArray(std::vector<std::uint8_t>{0, 1, 2, 3, 4, 5, 6, 7}),
                                       SampleArray(std::vector<std::int16_t>{0, 1, 2, 3, 4, 5, 6, 7}),
                                       SampleArray(std::vector<float>{0, 1, 2, 3, 4, 5, 6, 7}),
                                       SampleArray(std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7})})
    {
        const auto above = make_height_field(level_volume(volume_of(samples), 2.5));
        EXPECT_EQ(slice(*above, 0), (std::vector<double>{-2.5, -1.5, -0.5, 0.5}));
        EXPECT_EQ(slice(*above, 1), (std::vector<double>{1.5, 2.5, 3.5, 4.5}));
        const auto below = make_height_field(level_volume(volume_of(samples), 2.5, InsideIs::kBelow));
        EXPECT_EQ(slice(*below, 0), (std::vector<double>{2.5, 1.5, 0.5, -0.5}));
    }
}

TEST(HeightField, has_no_sample_at_0_where_samples_equal_the_isovalue)
{
    for (const InsideIs inside : {InsideIs::kAbove, InsideIs::kBelow})
    {
        const auto field = make_height_field(
            level_volume(volume_of(std::vector<std::uint8_t>{0, 1, 2, 3, 2, 2, 6, 7}), 2.0, inside));
        for (const std::size_t k : {0U, 1U})
            for (const double height : slice(*field, k))
                EXPECT_NE(height, 0.0);
        EXPECT_GT(slice(*field, 0)[2], 0.0) << "ties are inside";
    }
}

TEST(HeightField, samples_that_are_not_finite_are_outside_and_the_volume_is_not_touched)
{
    const auto volume = volume_of(std::vector<float>{0, 1, 2, 3, std::numeric_limits<float>::quiet_NaN(),
                                                     std::numeric_limits<float>::infinity(), 6, 7});
    const auto field = make_height_field(level_volume(volume, 0.5));
    EXPECT_LT(slice(*field, 1)[0], 0.0);
    EXPECT_LT(slice(*field, 1)[1], 0.0);
    EXPECT_TRUE(std::isnan(volume->at(0, 0, 1)));
}

TEST(HeightField, lies_in_the_grid_frame)
{
    const auto field = make_height_field(level_volume(volume_of(std::vector<float>(8, 1.0F)), 0.5));
    EXPECT_EQ(field->frame().at({1, 1, 1}), (Point3{1.0, 2.0, 3.0}));
    EXPECT_EQ(field->frame().first, (Point3{0, 0, 0}));
}

TEST(HeightField, of_what_has_no_interpolant_is_refused)
{
    EXPECT_THROW(level_volume(nullptr, 0.5), UsageError);
    EXPECT_THROW(level_volume(volume_of(std::vector<float>(4), {1, 2, 2}), 0.5), UsageError);
    EXPECT_THROW(level_volume(volume_of(std::vector<float>(7)), 0.5), UsageError);
    EXPECT_THROW(level_volume(volume_of(std::vector<float>(8)), std::numeric_limits<double>::quiet_NaN()),
                 UsageError);
}

} // namespace
} // namespace voroprobe
