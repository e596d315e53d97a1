#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "postprocess/print_check.h"

namespace voroprobe
{

//! For people, a line each; and for programs, the key `printable` of `check --json`.
std::string print_lines(const PrintCheck& check, const PrintOptions& options);
nlohmann::ordered_json print_json(const PrintCheck& check, const PrintOptions& options);

} // namespace voroprobe
