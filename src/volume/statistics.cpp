// The thresholds follow: N. Otsu, A threshold selection method from gray-level histograms, IEEE Trans. SMC
// 9(1), 1979.

#include "volume/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

#include "support/error.h"

namespace voroprobe
{

namespace
{

constexpr std::size_t kMaxDistinctValues = 4096;

//! Different values among the samples, given up once there are more than kMaxDistinctValues.
template <class Sample>
class DistinctValues
{
public:
    void insert(Sample value)
    {
        if (gave_up_ || (!values_.empty() && value == last_))
            return;
        last_ = value;
        values_.insert(value);
        gave_up_ = values_.size() > kMaxDistinctValues;
    }

    [[nodiscard]] std::size_t count() const { return gave_up_ ? 0 : values_.size(); }

private:
    std::unordered_set<Sample> values_;
    Sample last_{};
    bool gave_up_ = false;
};

//! The samples as values that occur so many times: each by itself.
template <class Sample>
class OccurringValues
{
public:
    explicit OccurringValues(const std::vector<Sample>& samples) : samples_(samples) {}

    //! Calls `visit(value, times)`.
    template <class Visit>
    void for_each(const Visit& visit) const
    {
        for (const Sample value : samples_)
            visit(value, std::size_t{1});
    }

private:
    const std::vector<Sample>& samples_;
};

//! The same for 8- and 16-bit samples: each value once.
template <class Sample>
requires(std::is_integral_v<Sample> && sizeof(Sample) <= 2) class OccurringValues<Sample>
{
public:
    explicit OccurringValues(const std::vector<Sample>& samples)
    {
        // Every second by itself: neighbours are often equal, and one count would wait for the other.
        std::vector<std::uint32_t> even(times_.size(), 0);
        std::vector<std::uint32_t> odd(times_.size(), 0);
        for (std::size_t begin = 0; begin < samples.size(); begin += kCountedAtOnce)
        {
            const std::size_t end = std::min(begin + kCountedAtOnce, samples.size());
            for (std::size_t i = begin; i + 1 < end; i += 2)
            {
                ++even[index(samples[i])];
                ++odd[index(samples[i + 1])];
            }
            if ((end - begin) % 2 != 0)
                ++even[index(samples[end - 1])];
            add_and_clear(even);
            add_and_clear(odd);
        }
    }

    template <class Visit>
    void for_each(const Visit& visit) const
    {
        for (std::size_t i = 0; i < times_.size(); ++i)
            if (times_[i] > 0)
                visit(static_cast<Sample>(static_cast<int>(i) + kLowest), times_[i]);
    }

private:
    static constexpr int kLowest = std::is_signed_v<Sample> ? -(1 << (8 * sizeof(Sample) - 1)) : 0;

    //! Fewer than 32 bits can count.
    static constexpr std::size_t kCountedAtOnce = std::size_t{1} << 31U;

    static std::size_t index(Sample value) { return static_cast<std::size_t>(int{value} - kLowest); }

    void add_and_clear(std::vector<std::uint32_t>& count)
    {
        for (std::size_t i = 0; i < count.size(); ++i)
            times_[i] += std::exchange(count[i], 0);
    }

    std::vector<std::size_t> times_ = std::vector<std::size_t>(std::size_t{1} << (8 * sizeof(Sample)), 0);
};

template <class Sample>
bool is_finite_sample(Sample value)
{
    if constexpr (std::is_floating_point_v<Sample>)
        return std::isfinite(value);
    return true;
}

//! Everything but the histogram; min > max where no sample is finite.
template <class Sample>
VolumeStatistics first_pass(const OccurringValues<Sample>& values)
{
    VolumeStatistics statistics;
    DistinctValues<Sample> distinct;
    Sample min = std::numeric_limits<Sample>::max();
    Sample max = std::numeric_limits<Sample>::lowest();
    double sum = 0.0;
    bool integer_valued = true;
    values.for_each(
        [&](Sample value, std::size_t times)
        {
            if constexpr (std::is_floating_point_v<Sample>)
            {
                if (!std::isfinite(value))
                {
                    (std::isnan(value) ? statistics.nan_count : statistics.infinite_count) += times;
                    return;
                }
                integer_valued = integer_valued && std::trunc(value) == value;
            }
            min = std::min(min, value);
            max = std::max(max, value);
            sum += static_cast<double>(value) * static_cast<double>(times);
            distinct.insert(value);
        });
    statistics.min = static_cast<double>(min);
    statistics.max = static_cast<double>(max);
    statistics.mean = sum;
    statistics.integer_valued = integer_valued;
    statistics.distinct_values = distinct.count();
    return statistics;
}

template <class Sample>
std::vector<std::size_t> make_histogram(const OccurringValues<Sample>& values, double min, double max,
                                        std::size_t bin_count)
{
    std::vector<std::size_t> histogram(bin_count, 0);
    const double half_range =
        0.5 * max - 0.5 * min; // halves, so that the range of all doubles does not overflow
    values.for_each(
        [&](Sample value, std::size_t times)
        {
            if (!is_finite_sample(value))
                return;
            const double fraction =
                half_range > 0.0 ? (0.5 * static_cast<double>(value) - 0.5 * min) / half_range : 0.0;
            const auto bin = static_cast<std::size_t>(fraction * static_cast<double>(bin_count));
            histogram[std::min(bin_count - 1, bin)] += times;
        });
    return histogram;
}

//! Sums over bins [0, b) of the histogram, in bin units, for the within-class variance of any range of bins
//! in O(1).
struct PrefixSums
{
    std::vector<double> weight{0.0};
    std::vector<double> moment{0.0};

    explicit PrefixSums(const std::vector<std::size_t>& histogram)
    {
        for (std::size_t bin = 0; bin < histogram.size(); ++bin)
        {
            const auto count = static_cast<double>(histogram[bin]);
            weight.push_back(weight.back() + count);
            moment.push_back(moment.back() + count * (static_cast<double>(bin) + 0.5));
        }
    }

    //! Part of the between-class variance that bins [first, last) add as one class, and minus infinity where
    //! they are empty: maximizing the sum of it minimizes the within-class variance (Otsu 1979, Eq. 14 to
    //! 18).
    [[nodiscard]] double between(std::size_t first, std::size_t last) const
    {
        const double w = weight[last] - weight[first];
        const double m = moment[last] - moment[first];
        return w > 0.0 ? m * m / w : -std::numeric_limits<double>::infinity();
    }
};

//! Borders of the best split of the bins into `classes` non-empty ranges, by dynamic programming over the
//! last border. Cost: O(classes * bins^2).
std::vector<std::size_t> best_borders(const PrefixSums& sums, std::size_t bins, std::size_t classes)
{
    constexpr double kNone = -std::numeric_limits<double>::infinity();
    std::vector<std::vector<double>> best(classes + 1, std::vector<double>(bins + 1, kNone));
    std::vector<std::vector<std::size_t>> border(classes + 1, std::vector<std::size_t>(bins + 1, 0));
    best[0][0] = 0.0;
    for (std::size_t used = 1; used <= classes; ++used)
        for (std::size_t last = used; last <= bins; ++last)
            for (std::size_t first = used - 1; first < last; ++first)
                if (const double value = best[used - 1][first] + sums.between(first, last);
                    value > best[used][last])
                {
                    best[used][last] = value;
                    border[used][last] = first;
                }

    std::vector<std::size_t> borders(classes - 1);
    std::size_t last = bins;
    for (std::size_t used = classes; used > 1; --used)
        borders[used - 2] = last = border[used][last];
    return borders;
}

//! The middle of the run of empty bins that `border` lies in: all borders of the run split the samples alike,
//! and the middle one is farthest from both classes (0.5 for a mask of zeros and ones).
std::size_t middle_of_gap(const std::vector<std::size_t>& histogram, std::size_t border)
{
    std::size_t first = border;
    while (first > 0 && histogram[first - 1] == 0)
        --first;
    std::size_t last = border;
    while (last < histogram.size() && histogram[last] == 0)
        ++last;
    return first + (last - first) / 2;
}

} // namespace

VolumeStatistics compute_statistics(const Volume& volume, std::size_t bin_count)
{
    return std::visit(
        [bin_count]<class Sample>(const std::vector<Sample>& samples)
        {
            const OccurringValues<Sample> values(samples);
            VolumeStatistics statistics = first_pass(values);
            const std::size_t finite = samples.size() - statistics.nan_count - statistics.infinite_count;
            if (finite == 0)
                statistics.min = statistics.max = 0.0;
            statistics.mean = finite == 0 ? 0.0 : statistics.mean / static_cast<double>(finite);
            statistics.integer_valued = statistics.integer_valued && finite > 0;
            statistics.histogram = make_histogram(values, statistics.min, statistics.max, bin_count);
            return statistics;
        },
        volume.samples);
}

std::vector<double> otsu_thresholds(const VolumeStatistics& statistics, std::size_t classes)
{
    constexpr std::size_t kMinClasses = 2;
    constexpr std::size_t kMaxClasses = 4;
    if (classes < kMinClasses || classes > kMaxClasses)
        throw UsageError("otsu_thresholds: " + std::to_string(classes) + " classes, expected 2 to 4");

    const std::vector<std::size_t>& histogram = statistics.histogram;
    const auto filled = static_cast<std::size_t>(
        std::count_if(histogram.begin(), histogram.end(), [](std::size_t count) { return count > 0; }));
    const std::size_t possible = std::min(classes, filled);
    if (possible < kMinClasses)
        return {};

    std::vector<double> thresholds;
    const double bins = static_cast<double>(histogram.size());
    for (const std::size_t border : best_borders(PrefixSums(histogram), histogram.size(), possible))
    {
        const double fraction = static_cast<double>(middle_of_gap(histogram, border)) / bins;
        thresholds.push_back((1.0 - fraction) * statistics.min + fraction * statistics.max);
    }
    return thresholds;
}

} // namespace voroprobe
