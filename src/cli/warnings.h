#pragma once

#include <string>
#include <vector>

namespace voroprobe
{

//! One line each on stderr: "voroprobe: warning: ...".
void print_warnings(const std::vector<std::string>& warnings);

} // namespace voroprobe
