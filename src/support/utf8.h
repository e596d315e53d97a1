#pragma once

#include <string>
#include <string_view>

namespace voroprobe
{

//! Whether all bytes are well-formed UTF-8 (Unicode 15, table 3-7: no overlong forms, no surrogates).
bool is_utf8(std::string_view text);

//! Text of a file that does not say how it is encoded, as UTF-8: what is no UTF-8 is taken for Latin-1, in
//! which every byte is a character.
std::string as_utf8(std::string text);

} // namespace voroprobe
