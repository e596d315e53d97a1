#include "compare/report_text.h"

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "compare/contestant_list.h"
#include "support/number_text.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

//! nullptr where the contestant did not take part or failed.
const Json* find_done(const Json& report, const std::string& name)
{
    for (const Json& contestant : report.at("contestants"))
        if (contestant.at("name") == name && contestant.at("status") == "done")
            return &contestant;
    return nullptr;
}

//! "41 %", "0.059 %"
std::string percent(double share)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", 100.0 * share);
    const std::string shown = 100.0 * share >= 99.5 ? "100" : text;
    return (shown.find('e') == std::string::npos ? shown : "under 0.01") + " %";
}

std::string ratio(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

std::string short_number(const Json& value)
{
    char text[32];
    if (!value.is_number())
        return "infinite";
    std::snprintf(text, sizeof text, "%.3g", value.get<double>());
    return text;
}

std::string millimetres(const Json& value)
{
    return short_number(value) + " mm";
}

//! "171 of 171 surfaces", "31 of 31 parts"
std::string surfaces(const Json& contestant)
{
    const Json& found = contestant.at("surfaces");
    return count_text(found.at("meshed")) + " of " + count_text(found.at("expected")) +
           (contestant.contains("labels") ? " parts" : " surfaces");
}

std::string vertices(const Json& contestant)
{
    return count_text(contestant.at("vertices")) + " vertices";
}

std::string about_reference(const Json& reference, bool ours_is_done)
{
    const Json& found = reference.at("surfaces");
    const std::string angles =
        percent(reference.at("angles").at("share_below_30")) + " of its triangles are under 30°.";
    const bool all = found.at("meshed") == found.at("expected");
    if (ours_is_done && all)
        return "Marching cubes needs " + vertices(reference) + ", and " + angles;
    return "Marching cubes has " + surfaces(reference) + " in " + vertices(reference) + ", and " + angles;
}

//! The trial with the smallest distance.
const Json& nearest_trial(const Json& sweep, const char* key)
{
    const Json& trials = sweep.at("trials");
    return *std::min_element(trials.begin(), trials.end(),
                             [&](const Json& a, const Json& b) { return a.at(key) < b.at(key); });
}

//! "by the RMS distance (0.29 mm) with 0.53 of its vertices", or that it was not reached, and how near it
//! came.
std::string at_equal(const Json& sweep, const Json& reference, const std::string& words, const char* answer,
                     const char* key)
{
    const std::string goal = "by the " + words + " distance (" + millimetres(reference.at(key)) + ") ";
    const Json& best = sweep.at(answer);
    if (best.is_null())
    {
        const Json& nearest = nearest_trial(sweep, key);
        return goal + "with no mesh that was tried (" + millimetres(nearest.at(key)) + " with " +
               vertices(nearest) + ")";
    }
    const double of_reference = best.at("of_reference");
    return goal + "with " + ratio(of_reference) +
           (of_reference > 1.0 ? " times its vertices, more and not fewer" : " of its vertices");
}

std::string about_equal_accuracy(const Json& equal)
{
    if (equal.is_null())
        return {};
    const Json& reference = equal.at("reference");
    for (const Json& sweep : equal.at("contestants"))
        if (sweep.at("name") == kOurs)
            return " Voroprobe is as near to the scan as marching cubes " +
                   at_equal(sweep, reference, "RMS", "at_equal_rms", "rms_mm") + ", and " +
                   at_equal(sweep, reference, "largest", "at_equal_max", "max_mm") + ".";
    return {};
}

//! "volumes change by 0.49 % at most"
std::string volume_change(const Json& contestant)
{
    return "volumes change by " + percent(contestant.at("labels").at("largest_volume_change")) + " at most";
}

//! What is said of a label map. Smoothing and decimation are the rule there: who does both is told of.
std::string label_headline(const Json& report)
{
    const Json* ours = find_done(report, kOurs);
    std::string text = ours == nullptr ? "Voroprobe made no mesh."
                                       : "Voroprobe has " + surfaces(*ours) + " of " +
                                             count_text(report.at("input").at("labels")) + " labels in " +
                                             vertices(*ours) + "; " + volume_change(*ours) + ".";
    if (const Json* staircase = find_done(report, kReference))
        text += " Marching cubes takes " + vertices(*staircase) +
                " for the staircase of the voxels, which "
                "nobody else is as near to.";
    if (const Json* usual = find_done(report, kUsualForLabels))
        text += " Smoothed and decimated it has " + surfaces(*usual) + " in " + vertices(*usual) + "; " +
                volume_change(*usual) + ", and " + percent(usual->at("angles").at("share_below_30")) +
                " of its triangles are under 30°.";
    return text;
}

//! A column of the tables: its name, and the cell of a contestant that is done.
struct Column
{
    std::string name;
    std::string (*cell)(const Json& contestant);
};

std::string yes_or_no(const Json& value)
{
    return value.get<bool>() ? "yes" : "no";
}

std::vector<Column> columns(const Json& report)
{
    std::vector<Column> columns{
        {"vertices", [](const Json& c) { return count_text(c.at("vertices")); }},
        {report.at("input").contains("labels") ? "parts" : "surfaces",
         [](const Json& c) {
             return count_text(c.at("surfaces").at("meshed")) + " of " +
                    count_text(c.at("surfaces").at("expected"));
         }},
        {"closed", [](const Json& c) { return yes_or_no(c.at("topology").at("closed")); }},
        {"manifold", [](const Json& c) { return yes_or_no(c.at("topology").at("manifold")); }},
        {"crossings", [](const Json& c) { return count_text(c.at("topology").at("self_intersections")); }},
        {"smallest angle", [](const Json& c) { return short_number(c.at("angles").at("min_deg")) + "°"; }},
        {"under 30°", [](const Json& c) { return percent(c.at("angles").at("share_below_30")); }},
        {"RMS mm", [](const Json& c) { return short_number(c.at("distance").at("mm").at("rms")); }},
        {"max mm", [](const Json& c) { return short_number(c.at("distance").at("mm").at("max")); }},
        {"seconds", [](const Json& c) { return short_number(c.at("time").at("cpu_seconds")); }},
    };
    if (report.at("input").contains("labels"))
        columns.insert(columns.begin() + 2, {"volume change", [](const Json& c) {
                                                 return percent(c.at("labels").at("largest_volume_change"));
                                             }});
    return columns;
}

//! Characters, not bytes: the degree sign has two.
std::size_t width_of(const std::string& text)
{
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string quoted(const std::string& text)
{
    if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
    std::string result = "\"";
    for (const char c : text)
        result += c == '"' ? "\"\"" : std::string(1, c);
    return result + '"';
}

//! Every number of a contestant by its path: "angles.min_deg". Lists are counted.
void flatten(const Json& value, const std::string& path,
             std::vector<std::pair<std::string, std::string>>& cells)
{
    if (path == "histograms" || path == "view" || path == "picture" || path == "description")
        return;
    if (value.is_object())
        for (const auto& [key, inner] : value.items())
        {
            std::string inner_path = path;
            inner_path.append(path.empty() ? "" : ".").append(key);
            flatten(inner, inner_path, cells);
        }
    else if (value.is_array())
        cells.emplace_back(path + ".count", std::to_string(value.size()));
    else
        cells.emplace_back(path, value.is_string() ? value.get<std::string>()
                                 : value.is_null() ? ""
                                                   : value.dump());
}

} // namespace

std::string headline(const nlohmann::ordered_json& report)
{
    if (report.at("input").contains("labels"))
        return label_headline(report);
    const Json* ours = find_done(report, kOurs);
    const Json* reference = find_done(report, kReference);
    std::string text = ours == nullptr ? "Voroprobe made no mesh."
                                       : "Voroprobe has " + surfaces(*ours) + " in " + vertices(*ours) + ".";
    if (reference != nullptr)
        text += " " + about_reference(*reference, ours != nullptr);
    return text + about_equal_accuracy(report.at("equal_accuracy"));
}

std::string report_csv(const nlohmann::ordered_json& report)
{
    std::vector<std::string> names;
    std::vector<std::vector<std::pair<std::string, std::string>>> rows;
    for (const Json& contestant : report.at("contestants"))
    {
        rows.emplace_back();
        flatten(contestant, "", rows.back());
        for (const auto& [name, value] : rows.back())
            if (std::find(names.begin(), names.end(), name) == names.end())
                names.push_back(name);
    }
    std::string text;
    for (const std::string& name : names)
        text.append(text.empty() ? "" : ",").append(quoted(name));
    for (const auto& row : rows)
    {
        text += "\r\n";
        for (std::size_t i = 0; i < names.size(); ++i)
        {
            const auto cell = std::find_if(row.begin(), row.end(),
                                           [&](const auto& entry) { return entry.first == names[i]; });
            text.append(i == 0 ? "" : ",").append(cell == row.end() ? "" : quoted(cell->second));
        }
    }
    return text + "\r\n";
}

std::string report_markdown(const nlohmann::ordered_json& report)
{
    std::string text = "**" + report.at("headline").get<std::string>() + "**\n\n| |";
    std::string rule = "|---|";
    const std::vector<Column> shown = columns(report);
    for (const Column& column : shown)
    {
        text.append(" ").append(column.name).append(" |");
        rule += "--:|";
    }
    text += "\n" + rule + "\n";
    for (const Json& contestant : report.at("contestants"))
    {
        text += "| " + contestant.at("title").get<std::string>() + " |";
        if (contestant.at("status") == "done")
            for (const Column& column : shown)
                text.append(" ").append(column.cell(contestant)).append(" |");
        else
            text +=
                " " + contestant.at("reason").get<std::string>() + " |" + std::string(shown.size() - 1, '|');
        text += "\n";
    }
    return text + "\n`" + report.at("command").get<std::string>() + "`\n";
}

std::string report_table(const nlohmann::ordered_json& report)
{
    std::vector<std::vector<std::string>> rows{{""}};
    const std::vector<Column> shown = columns(report);
    for (const Column& column : shown)
        rows.front().push_back(column.name);
    for (const Json& contestant : report.at("contestants"))
    {
        rows.push_back({contestant.at("title")});
        if (contestant.at("status") == "done")
            for (const Column& column : shown)
                rows.back().push_back(column.cell(contestant));
    }
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], width_of(row[i]));
    std::string text;
    for (std::size_t row = 0; row < rows.size(); ++row)
    {
        for (std::size_t i = 0; i < rows[row].size(); ++i)
        {
            const std::string space(widths[i] - width_of(rows[row][i]), ' ');
            text += i == 0 ? "  " + rows[row][i] + space : "  " + space + rows[row][i];
        }
        if (rows[row].size() == 1)
            text += "  failed: " + report.at("contestants").at(row - 1).at("reason").get<std::string>();
        text += "\n";
    }
    return text;
}

} // namespace voroprobe
