#include "cli/label_ranges.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "cli/number_text.h"
#include "cli/option_values.h"

namespace voroprobe
{
namespace
{

//! A number at the beginning of `text`, which is taken off it.
std::optional<LabelValue> take_number(std::string_view& text)
{
    LabelValue value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{})
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

std::string range_text(LabelValue first, LabelValue last)
{
    if (first == last)
        return std::to_string(first);
    return std::to_string(first) + (last == first + 1 ? ", " : " to ") + std::to_string(last);
}

} // namespace

LabelRanges::LabelRanges(std::string_view option, std::string_view text) : all_(text == "all")
{
    std::string_view rest = text;
    while (!all_)
    {
        const auto first = take_number(rest);
        auto last = first;
        if (first && rest.starts_with('-'))
        {
            rest.remove_prefix(1);
            last = take_number(rest);
        }
        if (!first || !last || *last < *first || (!rest.empty() && rest.front() != ','))
            refuse_value(option, text,
                         "all, or whole numbers and ranges separated by commas, such as 1,5,7-9");
        ranges_.emplace_back(*first, *last);
        if (rest.empty())
            return;
        rest.remove_prefix(1);
    }
}

bool LabelRanges::contains(LabelValue label) const
{
    return all_ ||
           std::any_of(ranges_.begin(), ranges_.end(),
                       [&](const auto& range) { return range.first <= label && label <= range.second; });
}

std::string LabelRanges::not_among(const std::vector<LabelValue>& there) const
{
    std::string text;
    for (const auto& [first, last] : ranges_)
    {
        const auto found = std::lower_bound(there.begin(), there.end(), first);
        if (found == there.end() || *found > last)
            text += (text.empty() ? "" : ", ") + range_text(first, last);
    }
    return text;
}

std::string labels_text(const std::vector<LabelValue>& labels)
{
    constexpr std::size_t kMostRanges = 40;
    std::string text;
    std::size_t ranges = 0;
    for (std::size_t i = 0, end = 0; i < labels.size(); i = end, ++ranges)
    {
        for (end = i + 1; end < labels.size() && labels[end] == labels[end - 1] + 1;)
            ++end;
        if (ranges == kMostRanges)
            return text + " and " + count_text(labels.size() - i) + " more";
        text += (text.empty() ? "" : ", ") + range_text(labels[i], labels[end - 1]);
    }
    return text;
}

} // namespace voroprobe
