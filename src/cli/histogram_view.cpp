#include "cli/histogram_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "cli/number_text.h"

namespace voroprobe
{

namespace
{

constexpr std::size_t kLongestBar = 40;

std::vector<std::size_t> regrouped(const std::vector<std::size_t>& histogram, std::size_t rows)
{
    std::vector<std::size_t> counts(std::min(rows, histogram.size()), 0);
    for (std::size_t bin = 0; bin < histogram.size(); ++bin)
        counts[bin * counts.size() / histogram.size()] += histogram[bin];
    return counts;
}

//! At least one character for a row with any sample.
std::string bar(std::size_t count, std::size_t largest)
{
    if (count == 0)
        return {};
    const double share = std::log1p(static_cast<double>(count)) / std::log1p(static_cast<double>(largest));
    return std::string(std::max<std::size_t>(1, static_cast<std::size_t>(share * kLongestBar)), '#');
}

std::string padded(const std::string& text, std::size_t width, bool right)
{
    const std::string blanks(width > text.size() ? width - text.size() : 0, ' ');
    return right ? blanks + text : text + blanks;
}

std::string share_text(double share)
{
    char text[16];
    std::snprintf(text, sizeof(text), "%7.3f %%", 100.0 * share);
    return text;
}

std::string marks_in_row(const std::vector<HistogramMark>& marks, double low, double high)
{
    std::string text;
    for (const HistogramMark& mark : marks)
        if (mark.value >= low && mark.value < high)
            text += "  <- " + mark.text;
    return text;
}

} // namespace

std::string histogram_view(const VolumeStatistics& statistics, const std::vector<HistogramMark>& marks,
                           std::size_t rows)
{
    const auto counts = regrouped(statistics.histogram, rows);
    const auto total = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    if (total == 0)
        return {};
    const std::size_t largest = *std::max_element(counts.begin(), counts.end());
    const auto row_start = [&](std::size_t row)
    {
        return std::lerp(statistics.min, statistics.max,
                         static_cast<double>(row) / static_cast<double>(counts.size()));
    };

    std::string view;
    for (std::size_t row = 0; row < counts.size(); ++row)
    {
        const double low = row_start(row);
        const double share = static_cast<double>(counts[row]) / static_cast<double>(total);
        view += padded(number_text(low), 12, true) + " |" +
                padded(bar(counts[row], largest), kLongestBar, false) + share_text(share) +
                marks_in_row(marks, low, row_start(row + 1)) + '\n';
    }
    return view;
}

} // namespace voroprobe
