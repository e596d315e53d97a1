#pragma once

#include <nlohmann/json_fwd.hpp>

namespace voroprobe
{

//! Versions of the libraries whose meshers take part: {"CGAL": "5.5.1", ...}.
nlohmann::ordered_json library_versions();

} // namespace voroprobe
