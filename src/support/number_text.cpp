#include "support/number_text.h"

#include <array>
#include <cstddef>
#include <cstdio>

namespace voroprobe
{

std::string number_text(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value == 0.0 ? 0.0 : value); // no "-0"
    return text.data();
}

std::string count_text(std::size_t count)
{
    std::string digits = std::to_string(count);
    for (std::ptrdiff_t i = static_cast<std::ptrdiff_t>(digits.size()) - 3; i > 0; i -= 3)
        digits.insert(static_cast<std::size_t>(i), 1, ',');
    return digits;
}

} // namespace voroprobe
