#include "compare/report_text.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "compare/report_page.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

Json contestant(const std::string& name, std::size_t vertices, std::size_t meshed, double share_below_30)
{
    return {{"name", name},
            {"title", name == "voroprobe" ? "Voroprobe" : "Marching cubes"},
            {"status", "done"},
            {"vertices", vertices},
            {"angles", {{"min_deg", 0.06}, {"share_below_30", share_below_30}}},
            {"surfaces", {{"meshed", meshed}, {"expected", 171}}},
            {"topology", {{"closed", true}, {"manifold", false}, {"self_intersections", 3}}},
            {"distance", {{"mm", {{"rms", 0.05}, {"max", nullptr}}}}},
            {"time", {{"cpu_seconds", 2.5}}}};
}

Json report()
{
    Json json = {
        {"headline", ""},
        {"command", "voroprobe compare scan.nrrd -o a.html"},
        {"input", {{"name", "scan <1> & co"}}},
        {"contestants",
         {contestant("voroprobe", 98000, 171, 0.0004), contestant("marching_cubes", 339000, 171, 0.412)}},
        {"equal_accuracy", nullptr}};
    json["contestants"].push_back(
        {{"name", "openvdb"}, {"title", "OpenVDB"}, {"status", "failed"}, {"reason", "not done after 2 s"}});
    return json;
}

TEST(ReportText, the_headline_says_what_each_has)
{
    EXPECT_EQ(headline(report()),
              "Voroprobe has 171 of 171 surfaces in 98,000 vertices. Marching cubes needs 339,000 "
              "vertices, and 41 % of its triangles are under 30°.");
}

TEST(ReportText, the_headline_of_a_label_map_tells_parts_and_volumes)
{
    Json json = report();
    json["input"]["labels"] = 33;
    json["contestants"].push_back(contestant("decimated", 12000, 160, 0.33));
    for (Json& one : json["contestants"])
        one["labels"] = {{"largest_volume_change", one.at("name") == "voroprobe" ? 0.0045 : 0.078}};
    EXPECT_EQ(
        headline(json),
        "Voroprobe has 171 of 171 parts of 33 labels in 98,000 vertices; volumes change by 0.45 % at most. "
        "Marching cubes takes 339,000 vertices for the staircase of the voxels, which nobody else is as near "
        "to. Smoothed and decimated it has 160 of 171 parts in 12,000 vertices; volumes change by 7.8 % at "
        "most, and 33 % of its "
        "triangles are under 30°.");
    EXPECT_NE(report_markdown(json).find("volume change"), std::string::npos);
    EXPECT_EQ(report_markdown(report()).find("volume change"), std::string::npos);
}

TEST(ReportText, the_headline_does_not_call_half_a_scan_the_whole)
{
    Json json = report();
    json["contestants"][1]["surfaces"]["meshed"] = 160;
    EXPECT_NE(headline(json).find("Marching cubes has 160 of 171 surfaces in 339,000 vertices"),
              std::string::npos);
}

TEST(ReportText, the_headline_is_plain_where_ours_is_no_better)
{
    Json json = report();
    json["equal_accuracy"] = {{"reference", {{"max_mm", 0.5}, {"rms_mm", 0.1}}},
                              {"contestants",
                               {{{"name", "voroprobe"},
                                 {"trials",
                                  {{{"vertices", 98000}, {"max_mm", 0.9}, {"rms_mm", 0.2}},
                                   {{"vertices", 400000}, {"max_mm", 0.7}, {"rms_mm", 0.1}}}},
                                 {"at_equal_max", nullptr},
                                 {"at_equal_rms", {{"vertices", 400000}, {"of_reference", 1.18}}}}}}};
    const std::string text = headline(json);
    EXPECT_NE(
        text.find(
            "by the largest distance (0.5 mm) with no mesh that was tried (0.7 mm with 400,000 vertices)"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("by the RMS distance (0.1 mm) with 1.18 times its vertices, more and not fewer"),
              std::string::npos)
        << text;
}

TEST(ReportText, the_headline_comes_without_ours_and_without_the_reference)
{
    Json json = report();
    json["contestants"] = Json::array({json["contestants"][2]});
    EXPECT_EQ(headline(json), "Voroprobe made no mesh.");
}

TEST(ReportText, the_csv_has_a_row_for_each_contestant_and_as_many_cells_in_all)
{
    const std::string csv = report_csv(report());
    std::vector<std::size_t> commas;
    std::size_t at = 0;
    for (std::size_t end = 0; (end = csv.find("\r\n", at)) != std::string::npos; at = end + 2)
        commas.push_back(
            static_cast<std::size_t>(std::count(csv.begin() + static_cast<std::ptrdiff_t>(at),
                                                csv.begin() + static_cast<std::ptrdiff_t>(end), ',')));
    EXPECT_EQ(commas, std::vector<std::size_t>(4, commas.front()));
    EXPECT_TRUE(csv.starts_with("name,title,status,vertices,angles.min_deg"));
    EXPECT_NE(csv.find("not done after 2 s"), std::string::npos);
}

TEST(ReportText, cells_of_the_csv_with_commas_are_quoted)
{
    Json json = report();
    json["contestants"][2]["reason"] = "a, \"b\"";
    EXPECT_NE(report_csv(json).find("\"a, \"\"b\"\"\""), std::string::npos);
}

TEST(ReportText, markdown_and_terminal_have_every_contestant)
{
    for (const std::string& text : {report_markdown(report()), report_table(report())})
        for (const char* title : {"Voroprobe", "Marching cubes", "OpenVDB", "not done after 2 s", "infinite"})
            EXPECT_NE(text.find(title), std::string::npos) << title << " in\n" << text;
}

TEST(ReportPage, what_a_scan_is_called_cannot_break_the_page)
{
    Json json = report();
    json["input"]["path"] = "</script><script>alert(1)</script>";
    const std::string page = report_page(json, {{"voroprobe", "AAAA"}});
    EXPECT_EQ(page.find("</script><script>alert"), std::string::npos);
    EXPECT_NE(page.find("id=\"view-voroprobe\">AAAA<"), std::string::npos);
    EXPECT_EQ(page.find("the report goes here"), std::string::npos);
}

TEST(ReportPage, the_index_has_totals)
{
    const std::string page = index_page({{"a.html", report()}, {"b.html", report()}});
    EXPECT_NE(page.find("href=\"a.html\""), std::string::npos);
    EXPECT_NE(page.find("scan &lt;1> &amp; co"), std::string::npos);
    EXPECT_NE(page.find("2 scans"), std::string::npos);
    EXPECT_NE(page.find("<td>342 of 342</td><td>196,000</td>"), std::string::npos);
}

} // namespace

} // namespace voroprobe
