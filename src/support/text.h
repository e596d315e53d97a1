#pragma once

#include <string>
#include <string_view>

namespace voroprobe
{

//! The letters A to Z made small, all other bytes as they are.
std::string lower_case(std::string text);

//! Without the blanks, tabs and carriage returns at both ends. The result is a part of `text`.
std::string_view trimmed(std::string_view text);

} // namespace voroprobe
