#include "cli/option_values.h"

#include <charconv>
#include <cmath>
#include <optional>

#include "support/error.h"

namespace voroprobe
{

const NumberRule kAnyFinite{[](double) { return true; }, "a finite number"};
const NumberRule kLength{[](double x) { return x > 0.0; }, "a number > 0, mm"};
const NumberRule kVolume{[](double x) { return x > 0.0; }, "a number > 0, mm3"};
const NumberRule kFacetAngle{[](double x) { return x >= 0.0 && x <= 30.0; },
                             "a number from 0 to 30, degrees"};

namespace
{

template <typename Number>
std::optional<Number> whole_text_as(std::string_view text)
{
    if (text.starts_with('+')) // from_chars knows no plus sign
        text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

} // namespace

void refuse_value(std::string_view option, std::string_view text, std::string_view allowed)
{
    throw UsageError(std::string(option) + " is '" + std::string(text) +
                     "'; allowed: " + std::string(allowed));
}

double parse_number(std::string_view option, std::string_view text, const NumberRule& rule)
{
    const auto value = whole_text_as<double>(text);
    if (!value || !std::isfinite(*value) || !rule.allows(*value))
        refuse_value(option, text, rule.words);
    return *value;
}

std::size_t parse_count(std::string_view option, std::string_view text, std::size_t lowest)
{
    const auto value = whole_text_as<std::size_t>(text);
    if (!value || *value < lowest)
        refuse_value(option, text, "a whole number >= " + std::to_string(lowest));
    return *value;
}

Vec3 parse_spacing(std::string_view option, std::string_view text)
{
    constexpr std::string_view kAllowed = "three numbers > 0 separated by commas, mm (x,y,z)";
    Vec3 spacing;
    std::string_view rest = text;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const std::size_t comma = rest.find(',');
        const bool last = axis == 2;
        const auto value = whole_text_as<double>(rest.substr(0, comma));
        if (!value || !std::isfinite(*value) || *value <= 0.0 || (comma == std::string_view::npos) != last)
            refuse_value(option, text, kAllowed);
        spacing[axis] = *value;
        rest.remove_prefix(last ? rest.size() : comma + 1);
    }
    return spacing;
}

} // namespace voroprobe
