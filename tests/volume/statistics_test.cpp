#include "volume/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "support/error.h"
#include "support/random.h"

namespace voroprobe
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <class Sample>
Volume row_volume(std::vector<Sample> samples)
{
    const StoredLattice lattice{.size = {samples.size(), 1, 1}};
    return make_volume(lattice, std::move(samples));
}

template <class Sample>
VolumeStatistics statistics_of(std::vector<Sample> samples, std::size_t bins = 1024)
{
    return compute_statistics(row_volume(std::move(samples)), bins);
}

TEST(Statistics, range_mean_and_histogram_of_integers)
{
    const VolumeStatistics statistics = statistics_of<std::int16_t>({-4, 4, 4, 0}, 4);
    EXPECT_EQ(statistics.min, -4.0);
    EXPECT_EQ(statistics.max, 4.0);
    EXPECT_EQ(statistics.mean, 1.0);
    EXPECT_TRUE(statistics.integer_valued);
    EXPECT_EQ(statistics.distinct_values, 3U);
    EXPECT_EQ(statistics.histogram, (std::vector<std::size_t>{1, 0, 1, 2}));
}

TEST(Statistics, samples_that_are_not_finite_are_counted_and_left_out)
{
    const VolumeStatistics statistics = statistics_of<double>({kNan, 1.5, kInfinity, 2.5, -kInfinity, kNan});
    EXPECT_EQ(statistics.nan_count, 2U);
    EXPECT_EQ(statistics.infinite_count, 2U);
    EXPECT_EQ(statistics.min, 1.5);
    EXPECT_EQ(statistics.max, 2.5);
    EXPECT_EQ(statistics.mean, 2.0);
    EXPECT_FALSE(statistics.integer_valued);
    EXPECT_EQ(std::accumulate(statistics.histogram.begin(), statistics.histogram.end(), std::size_t{0}), 2U);
}

TEST(Statistics, a_volume_without_a_finite_sample_is_empty)
{
    const VolumeStatistics statistics = statistics_of<float>({std::nanf(""), std::nanf("")});
    EXPECT_EQ(statistics.nan_count, 2U);
    EXPECT_EQ(statistics.min, 0.0);
    EXPECT_EQ(statistics.max, 0.0);
    EXPECT_EQ(statistics.distinct_values, 0U);
    EXPECT_FALSE(statistics.integer_valued);
    EXPECT_TRUE(otsu_thresholds(statistics, 2).empty());
}

TEST(Statistics, the_range_of_all_doubles_does_not_overflow)
{
    constexpr double kLargest = std::numeric_limits<double>::max();
    const VolumeStatistics statistics = statistics_of<double>({-kLargest, 0.0, kLargest}, 4);
    EXPECT_EQ(statistics.histogram, (std::vector<std::size_t>{1, 0, 1, 1}));
}

TEST(Statistics, distinct_values_are_counted_up_to_a_limit)
{
    std::vector<std::int32_t> values(4097);
    std::iota(values.begin(), values.end(), 0);
    EXPECT_EQ(statistics_of(values).distinct_values, 0U);
    values.pop_back();
    EXPECT_EQ(statistics_of(values).distinct_values, 4096U);
    const std::vector<std::uint16_t> narrow(values.begin(), values.end());
    EXPECT_EQ(statistics_of(narrow).distinct_values, 4096U);
}

TEST(Statistics, whole_floats_are_integer_valued)
{
    EXPECT_TRUE(statistics_of<float>({1.0F, -3.0F, 1e20F}).integer_valued);
    EXPECT_FALSE(statistics_of<float>({1.0F, -3.0F, 0.5F}).integer_valued);
}

TEST(OtsuThresholds, a_mask_is_split_at_one_half)
{
    EXPECT_EQ(otsu_thresholds(statistics_of<std::uint8_t>({0, 0, 1, 0, 1}), 2), std::vector<double>{0.5});
}

TEST(OtsuThresholds, there_are_no_more_classes_than_values)
{
    EXPECT_TRUE(otsu_thresholds(statistics_of<std::uint8_t>({7, 7, 7}), 3).empty());
    EXPECT_EQ(otsu_thresholds(statistics_of<std::uint8_t>({0, 100, 100}), 4).size(), 1U);
}

TEST(OtsuThresholds, only_two_to_four_classes_are_known)
{
    const VolumeStatistics statistics = statistics_of<std::uint8_t>({0, 1});
    EXPECT_THROW(otsu_thresholds(statistics, 1), UsageError);
    EXPECT_THROW(otsu_thresholds(statistics, 5), UsageError);
}

//! Sum over the classes of the squared deviation from the class mean.
double within_class_variance(const std::vector<double>& samples, const std::vector<double>& thresholds)
{
    double total = 0.0;
    for (std::size_t c = 0; c <= thresholds.size(); ++c)
    {
        const double low = c == 0 ? -kInfinity : thresholds[c - 1];
        const double high = c == thresholds.size() ? kInfinity : thresholds[c];
        double count = 0.0;
        double sum = 0.0;
        double squares = 0.0;
        for (const double value : samples)
            if (value >= low && value < high)
            {
                count += 1.0;
                sum += value;
                squares += value * value;
            }
        total += count > 0.0 ? squares - sum * sum / count : 0.0;
    }
    return total;
}

//! The least of it over all ways to put the borders still to come halfway between whole numbers up to 32.
double least_variance(const std::vector<double>& samples, const std::vector<double>& borders,
                      std::size_t classes)
{
    if (borders.size() + 1 == classes)
        return within_class_variance(samples, borders);
    double best = kInfinity;
    for (double next = borders.empty() ? 0.5 : borders.back() + 1.0; next < 32.0; ++next)
    {
        std::vector<double> more = borders;
        more.push_back(next);
        best = std::min(best, least_variance(samples, more, classes));
    }
    return best;
}

TEST(OtsuThresholds, no_other_split_has_less_variance_within_its_classes)
{
    Random random(7);
    std::vector<double> samples;
    for (int i = 0; i < 300; ++i)
        samples.push_back(std::floor(random.uniform(0.0, 10.0) + (i % 3) * 11.0));
    samples.insert(samples.end(), {0.0, 32.0});
    const VolumeStatistics statistics = statistics_of(samples, 32);

    for (const std::size_t classes : {2U, 3U, 4U})
    {
        const std::vector<double> found = otsu_thresholds(statistics, classes);
        ASSERT_EQ(found.size(), classes - 1);
        EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
        const double best = least_variance(samples, {}, classes);
        EXPECT_NEAR(within_class_variance(samples, found), best, 1e-6) << classes;
    }
}

} // namespace

} // namespace voroprobe
