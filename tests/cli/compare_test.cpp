// `voroprobe compare` as its users run it, on a ball.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program_fixture.h"

namespace voroprobe
{

namespace
{

class CompareTest : public ProgramTest
{
protected:
    //! Arguments of a comparison that takes a second, and whatever else is asked.
    [[nodiscard]] std::vector<std::string> compare(const std::vector<std::string>& more) const
    {
        std::vector<std::string> arguments{
            "compare", folder_ / "ball.mha", "--isovalue", "0",         "--sweep-seconds",
            "0",       "--pictures",         "off",        "--samples", "500"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    [[nodiscard]] nlohmann::json report(const std::string& name) const
    {
        return nlohmann::json::parse(program::read_text(folder_.path() / name));
    }
};

TEST_F(CompareTest, the_page_and_all_that_goes_beside_it_are_written)
{
    const auto outcome =
        program::run(compare({"-o", folder_ / "page.html", "--contestants", "voroprobe,marching_cubes"}));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(folder_.names(),
              (std::vector<std::string>{"ball.mha", "page.csv", "page.html", "page.json", "page.md"}));
    EXPECT_TRUE(outcome.out.starts_with("Voroprobe has 1 of 1 surfaces in "));
    const auto json = report("page.json");
    EXPECT_EQ(json.at("contestants").size(), 2U);
    EXPECT_EQ(json.at("input").at("isovalue"), 0.0);
    EXPECT_TRUE(json.at("equal_accuracy").is_null());
    EXPECT_TRUE(json.at("command").get<std::string>().starts_with("voroprobe compare "));
    const std::string page = program::read_text(folder_.path() / "page.html");
    EXPECT_NE(page.find(json.at("headline").get<std::string>()), std::string::npos);
    EXPECT_EQ(page.find("http://"), page.find("http://www.w3.org")); // names of formats, nothing to fetch
}

TEST_F(CompareTest, a_mesh_that_is_brought_takes_part)
{
    ASSERT_EQ(program::run(mesh_ball("mine.ply", {"-q"})).status, 0);
    const auto outcome = program::run(compare({"-o", folder_ / "page.html", "--contestants", "marching_cubes",
                                               "--with", "mine=" + folder_ / "mine.ply", "-q"}));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const auto mine = report("page.json").at("contestants").at(1);
    EXPECT_EQ(mine.at("name"), "mine");
    EXPECT_EQ(mine.at("surfaces").at("meshed"), 1);
}

TEST_F(CompareTest, a_contestant_that_fails_is_told_of_and_the_page_comes)
{
    const auto outcome =
        program::run(compare({"-o", folder_ / "page.html", "--contestants", "marching_cubes,decimated"}));
    EXPECT_EQ(outcome.status, 0) << outcome.err; // ours is not there: what waits for it fails
    const auto decimated = report("page.json").at("contestants").at(1);
    EXPECT_EQ(decimated.at("status"), "failed");
    EXPECT_NE(outcome.out.find(decimated.at("reason").get<std::string>()), std::string::npos);
    EXPECT_TRUE(outcome.out.starts_with("Voroprobe made no mesh."));
}

TEST_F(CompareTest, several_scans_get_a_page_each_and_an_index)
{
    std::filesystem::create_directory(folder_.path() / "scans");
    for (const char* name : {"scans/a.mha", "scans/b.mha"})
        std::filesystem::copy_file(folder_.path() / "ball.mha", folder_.path() / name);
    const auto outcome = program::run({"compare", folder_ / "scans", "--isovalue", "0", "--sweep-seconds",
                                       "0", "--pictures", "off", "--samples", "500", "--contestants",
                                       "voroprobe,marching_cubes", "-o", folder_ / "pages"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    for (const char* name : {"a.html", "a.json", "b.html", "b.csv", "index.html"})
        EXPECT_TRUE(std::filesystem::exists(folder_.path() / "pages" / name)) << name;
    const std::string index = program::read_text(folder_.path() / "pages" / "index.html");
    EXPECT_NE(index.find("2 scans"), std::string::npos);
    EXPECT_NE(index.find("<td>2 of 2</td>"), std::string::npos);
}

TEST_F(CompareTest, scans_whose_pages_would_have_one_name_are_refused)
{
    for (const std::string folder : {"before", "after"})
    {
        std::filesystem::create_directory(folder_.path() / folder);
        std::filesystem::copy_file(folder_.path() / "ball.mha", folder_.path() / folder / "head.mha");
    }
    const auto outcome = program::run({"compare", folder_ / "before/head.mha", folder_ / "after/head.mha",
                                       "-o", folder_ / "pages", "--isovalue", "0"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find("head.html"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "pages"));
}

TEST_F(CompareTest, a_folder_of_one_volume_gets_a_folder_as_well_and_a_page_is_none)
{
    std::filesystem::create_directory(folder_.path() / "scans");
    std::filesystem::copy_file(folder_.path() / "ball.mha", folder_.path() / "scans/a.mha");
    const std::vector<std::string> options{
        "--isovalue", "0",  "--sweep-seconds", "0",         "--pictures", "off", "--samples",
        "500",        "-q", "--contestants",   "voroprobe", "-o"};
    const auto into = [&](const std::string& output)
    {
        std::vector<std::string> arguments{"compare", folder_ / "scans"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        arguments.push_back(folder_ / output);
        return program::run(arguments);
    };
    EXPECT_EQ(into("pages").status, 0);
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "pages" / "a.html"));
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "pages" / "index.html"));

    const auto page = into("pages.html");
    EXPECT_EQ(page.status, 2);
    EXPECT_TRUE(is_one_error_line(page.err)) << page.err;
    EXPECT_NE(page.err.find("pages.html'; allowed with several scans: a folder"), std::string::npos)
        << page.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "pages.html"));
}

TEST_F(CompareTest, a_scan_that_cannot_be_read_does_not_keep_the_others_from_their_pages)
{
    program::write_text(folder_.path() / "broken.mha", "nothing");
    const auto outcome = program::run({"compare", folder_ / "broken.mha", folder_ / "ball.mha", "--isovalue",
                                       "0", "--sweep-seconds", "0", "--pictures", "off", "--samples", "500",
                                       "--contestants", "voroprobe", "-o", folder_ / "pages"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_NE(outcome.err.find("broken.mha"), std::string::npos);
    EXPECT_EQ(outcome.err.find("broken.mha: " + folder_ / "broken.mha"), std::string::npos) << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "pages" / "ball.html"));
}

TEST_F(CompareTest, wrong_usage_is_refused_in_one_line_before_anything_is_run)
{
    const std::vector<std::vector<std::string>> wrong{
        {"-o", folder_ / "page.pdf"},
        {},
        {"-o", folder_ / "page.html", "--contestants", "voroprobe,nobody"},
        {"-o", folder_ / "page.html", "--with", "mine"},
        {"-o", folder_ / "page.html", "--with", "voroprobe=x.ply"},
        {"-o", folder_ / "page.html", "--contestant-seconds", "0"},
        {"-o", folder_ / "page.html", "--at-once", "0"},
        {"-o", folder_ / "page.html", "--pictures", "maybe"},
    };
    for (const auto& arguments : wrong)
    {
        const auto outcome = program::run(compare(arguments));
        EXPECT_EQ(outcome.status, 2) << testing::PrintToString(arguments);
        EXPECT_TRUE(is_one_error_line(outcome.err)) << outcome.err;
        EXPECT_EQ(folder_.names(), std::vector<std::string>{"ball.mha"});
    }
}

TEST_F(CompareTest, a_label_map_is_compared_label_by_label)
{
    Phantom labels = ball_phantom();
    labels.field = [](const Point3& p) {
        return distance(p, {12, 12, 12}) > 6.0 ? 0.0 : p.x < 12.0 ? 3.0 : 5.0;
    };
    write_phantom(labels, folder_ / "labels.mha");
    const auto outcome = program::run({"compare", folder_ / "labels.mha", "--labels", "all", "-o",
                                       folder_ / "page.html", "--pictures", "off", "--samples", "500"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("Voroprobe has 2 of 2 parts of 2 labels in ")) << outcome.out;
    const auto json = report("page.json");
    EXPECT_EQ(json.at("contestants").size(), 4U);
    EXPECT_EQ(json.at("input").at("labels"), 2);
    EXPECT_FALSE(json.at("input").contains("isovalue"));
    EXPECT_EQ(json.at("surfaces").at(0).at("label"), 3);
    EXPECT_TRUE(json.at("equal_accuracy").is_null());

    for (const std::vector<std::string>& wrong :
         std::vector<std::vector<std::string>>{{"--isovalue", "1"},
                                               {"--with", "mine=" + folder_ / "page.html"},
                                               {"--contestants", "openvdb"},
                                               {"--smooth", "joint"},
                                               {"--max-labels", "1"},
                                               {"--names", "names.txt"}})
    {
        std::vector<std::string> arguments{"compare", folder_ / "labels.mha", "--labels", "all",
                                           "-o",      folder_ / "other.html"};
        arguments.insert(arguments.end(), wrong.begin(), wrong.end());
        const auto refused = program::run(arguments);
        EXPECT_EQ(refused.status, 2) << testing::PrintToString(wrong);
        EXPECT_TRUE(is_one_error_line(refused.err)) << refused.err;
    }
}

TEST_F(CompareTest, what_is_no_volume_is_refused)
{
    ASSERT_EQ(program::run(mesh_ball("mine.ply", {"-q"})).status, 0);
    const auto outcome = program::run({"compare", folder_ / "mine.ply", "-o", folder_ / "page.html"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(is_one_error_line(outcome.err)) << outcome.err;
}

} // namespace

} // namespace voroprobe
