#pragma once

#include <string_view>

namespace voroprobe
{

//! report/page.html, as it was built into the program.
std::string_view page_template();

//! report/index.html, likewise.
std::string_view index_template();

} // namespace voroprobe
