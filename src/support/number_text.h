#pragma once

#include <string>

namespace voroprobe
{

//! A number for people: six significant digits, no trailing zeros ("0.375", "1150.5", "1e-09").
std::string number_text(double value);

} // namespace voroprobe
