#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace voroprobe
{

//! A packed mesh of a contestant, see view_mesh.h.
struct PageView
{
    std::string name;
    std::string packed;
};

//! The page: one HTML file with everything in it, made by filling the report and the meshes into the template
//! of report/.
std::string report_page(const nlohmann::ordered_json& report, const std::vector<PageView>& views);

//! A page that lists others, with totals: one row for each (file name, report).
std::string index_page(const std::vector<std::pair<std::string, nlohmann::ordered_json>>& pages);

} // namespace voroprobe
