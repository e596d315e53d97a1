#pragma once

#include <string_view>

namespace voroprobe
{

//! Order of names in which runs of digits compare as numbers: "slice2" before "slice10". Strict and total;
//! equal numbers with different leading zeros are ordered by their text.
bool natural_less(std::string_view a, std::string_view b);

} // namespace voroprobe
