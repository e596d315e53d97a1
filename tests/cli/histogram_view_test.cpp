#include "cli/histogram_view.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

namespace voroprobe
{
namespace
{

VolumeStatistics statistics_with(std::vector<std::size_t> histogram)
{
    VolumeStatistics statistics;
    statistics.min = 0.0;
    statistics.max = static_cast<double>(histogram.size());
    statistics.histogram = std::move(histogram);
    return statistics;
}

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

std::ptrdiff_t bar_length(const std::string& line)
{
    return std::count(line.begin(), line.end(), '#');
}

TEST(HistogramView, has_a_row_per_group_of_bins)
{
    EXPECT_EQ(lines_of(histogram_view(statistics_with(std::vector<std::size_t>(1024, 1)), {}, 24)).size(),
              24U);
    EXPECT_EQ(lines_of(histogram_view(statistics_with({1, 2, 3}), {}, 24)).size(), 3U);
}

TEST(HistogramView, longer_bars_hold_more_samples)
{
    const auto lines = lines_of(histogram_view(statistics_with({1000, 0, 1, 100}), {}, 4));
    EXPECT_EQ(bar_length(lines[1]), 0);
    EXPECT_GE(bar_length(lines[2]), 1);
    EXPECT_LT(bar_length(lines[2]), bar_length(lines[3]));
    EXPECT_LT(bar_length(lines[3]), bar_length(lines[0]));
}

TEST(HistogramView, marks_stand_in_the_row_that_holds_them)
{
    const auto lines = lines_of(histogram_view(statistics_with({1, 1, 1, 1}), {{2.5, "here"}}, 4));
    for (std::size_t row = 0; row < 4; ++row)
        EXPECT_EQ(lines[row].find("<- here") != std::string::npos, row == 2) << row;
}

TEST(HistogramView, of_no_samples_is_empty)
{
    EXPECT_EQ(histogram_view(statistics_with({0, 0, 0}), {}), "");
    EXPECT_EQ(histogram_view(statistics_with({}), {}), "");
}

} // namespace
} // namespace voroprobe
