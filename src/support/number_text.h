#pragma once

#include <cstddef>
#include <string>

namespace voroprobe
{

//! A number for people: six significant digits, no trailing zeros ("0.375", "1150.5", "1e-09").
std::string number_text(double value);

//! A count with thousands marked: "1,234,567".
std::string count_text(std::size_t count);

} // namespace voroprobe
