#include "support/number_text.h"

#include <array>
#include <cstdio>

namespace voroprobe
{

std::string number_text(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value == 0.0 ? 0.0 : value); // no "-0"
    return text.data();
}

} // namespace voroprobe
