#include "compare/report_page.h"

#include <string_view>

#include <nlohmann/json.hpp>

#include "compare/contestant_list.h"
#include "compare/page_template.h"
#include "support/check.h"
#include "support/number_text.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

//! Where the templates are filled.
constexpr std::string_view kData = "<!-- the report goes here -->";
constexpr std::string_view kRows = "<!-- the rows go here -->";

std::string filled(std::string_view page, std::string_view mark, const std::string& content)
{
    const std::size_t at = page.find(mark);
    CHECK_NE(at, std::string_view::npos);
    std::string result(page.substr(0, at));
    result += content;
    result += page.substr(at + mark.size());
    return result;
}

//! JSON that no browser takes for the end of a script.
std::string embedded(const Json& json)
{
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; at += 6)
        text.replace(at, 1, "\\u003c");
    return text;
}

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    return result;
}

const Json* find_done(const Json& report, const char* name)
{
    for (const Json& contestant : report.at("contestants"))
        if (contestant.at("name") == name && contestant.at("status") == "done")
            return &contestant;
    return nullptr;
}

//! Sums over the scans of one contestant.
struct Totals
{
    std::size_t scans = 0;
    std::size_t vertices = 0;
    std::size_t meshed = 0;
    std::size_t expected = 0;

    void add(const Json& contestant)
    {
        ++scans;
        vertices += contestant.at("vertices").get<std::size_t>();
        meshed += contestant.at("surfaces").at("meshed").get<std::size_t>();
        expected += contestant.at("surfaces").at("expected").get<std::size_t>();
    }

    [[nodiscard]] std::string cells() const
    {
        return "<td>" + count_text(meshed) + " of " + count_text(expected) + "</td><td>" +
               count_text(vertices) + "</td>";
    }
};

std::string cells_of(const Json& report, const char* name, Totals& totals)
{
    const Json* contestant = find_done(report, name);
    if (contestant == nullptr)
        return "<td colspan=\"2\">failed</td>";
    totals.add(*contestant);
    Totals one;
    one.add(*contestant);
    return one.cells();
}

} // namespace

std::string report_page(const nlohmann::ordered_json& report, const std::vector<PageView>& views)
{
    std::string data =
        "<script type=\"application/json\" id=\"report-data\">" + embedded(report) + "</script>\n";
    for (const PageView& view : views)
        data += "<script type=\"text/plain\" id=\"view-" + escaped(view.name) + "\">" + view.packed +
                "</script>\n";
    return filled(page_template(), kData, data);
}

std::string index_page(const std::vector<std::pair<std::string, nlohmann::ordered_json>>& pages)
{
    std::string rows;
    Totals ours;
    Totals reference;
    for (const auto& [file, report] : pages)
        rows += "<tr><th scope=\"row\"><a href=\"" + escaped(file) + "\">" +
                escaped(report.at("input").at("name").get<std::string>()) + "</a><p>" +
                escaped(report.at("headline").get<std::string>()) + "</p></th>" +
                cells_of(report, kOurs, ours) + cells_of(report, kReference, reference) + "</tr>\n";
    rows += "<tr class=\"total\"><th scope=\"row\">" + count_text(pages.size()) + " scans</th>" +
            ours.cells() + reference.cells() + "</tr>\n";
    return filled(index_template(), kRows, rows);
}

} // namespace voroprobe
