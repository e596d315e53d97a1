#include "cli/number_text.h"

#include <array>
#include <cstdio>

namespace voroprobe
{

namespace
{

std::string printed(const char* format, double value)
{
    std::array<char, 64> text{};
    const int length = std::snprintf(text.data(), text.size(), format, value);
    return {text.data(), static_cast<std::size_t>(length)};
}

} // namespace

std::string triple_text(const Vec3& values, const std::string& separator)
{
    return number_text(values.x) + separator + number_text(values.y) + separator + number_text(values.z);
}

std::string plural_text(std::size_t count, const std::string& one, const std::string& many)
{
    return count_text(count) + ' ' + (count == 1 ? one : many);
}

std::string plural_text(std::size_t count, const std::string& one)
{
    return plural_text(count, one, one + 's');
}

std::string percent_text(double share)
{
    return printed("%.3g %%", 100.0 * share);
}

std::string seconds_text(double seconds)
{
    return printed("%.2f s", seconds);
}

std::string bytes_text(std::size_t bytes)
{
    constexpr std::array<const char*, 5> kUnits{"bytes", "kB", "MB", "GB", "TB"};
    auto value = static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; value >= 1000.0 && unit + 1 < kUnits.size(); ++unit)
        value /= 1000.0;
    return printed("%.3g ", value) + kUnits[unit];
}

} // namespace voroprobe
