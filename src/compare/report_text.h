#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace voroprobe
{

//! Everything below is taken from what report.json holds, and from nothing else.

//! What came out, in one to three sentences: ours, the reference, and both at equal accuracy.
std::string headline(const nlohmann::ordered_json& report);

//! One row for each contestant, a header before them; RFC 4180. What a contestant does not have is empty.
std::string report_csv(const nlohmann::ordered_json& report);

//! Headline and table for a pull request.
std::string report_markdown(const nlohmann::ordered_json& report);

//! For a terminal: a line for each contestant, those that failed with their reason.
std::string report_table(const nlohmann::ordered_json& report);

} // namespace voroprobe
