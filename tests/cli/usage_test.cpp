#include "program_fixture.h"

namespace voroprobe
{
namespace
{

using program::Outcome;
using program::run;

class UsageTest : public ProgramTest
{
protected:
    //! Status 2 and one line that holds all of `words`; nothing written.
    void expect_wrong_usage(const std::vector<std::string>& arguments, const std::vector<std::string>& words)
    {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_TRUE(is_one_error_line(outcome.err)) << outcome.err;
        for (const std::string& word : words)
            EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " is not in: " << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "out.stl"));
    }
};

TEST_F(UsageTest, commands_and_their_arguments_are_required)
{
    expect_wrong_usage({}, {"--help"});
    expect_wrong_usage({"melt"}, {"'melt' is no command", "allowed: mesh, info, check, compare, process"});
    expect_wrong_usage({"mesh"}, {"INPUT is '' or missing"});
    expect_wrong_usage({"mesh", folder_ / "ball.mha"}, {"--output"});
    expect_wrong_usage({"info"}, {"INPUT"});
    expect_wrong_usage({"mesh", "", "-o", folder_ / "out.stl"}, {"INPUT", "''", "file or a folder"});
}

TEST_F(UsageTest, unknown_and_repeated_options_are_refused)
{
    expect_wrong_usage(mesh_ball("out.stl", {"--sizes", "1"}), {"--sizes is no option of voroprobe mesh"});
    expect_wrong_usage(mesh_ball("out.stl", {"--size", "1", "--size", "2"}), {"--size"});
    expect_wrong_usage(mesh_ball("out.stl", {"--size"}), {"--size"});
    expect_wrong_usage(mesh_ball("out.stl", {"another.mha"}), {"'another.mha' is one argument too many"});
    expect_wrong_usage({"info", folder_ / "ball.mha", "--version"}, {"--version is no option"});
}

TEST_F(UsageTest, a_misspelt_option_is_told_with_the_one_that_was_meant)
{
    expect_wrong_usage(mesh_ball("out.stl", {"--isovlaue", "1"}), {"--isovlaue", "did you mean --isovalue?"});
    expect_wrong_usage(mesh_ball("out.stl", {"--distanse=1"}),
                       {"--distanse is no option", "did you mean --distance?", "voroprobe mesh --help"});
    expect_wrong_usage({"info", folder_ / "ball.mha", "--jsn"}, {"--jsn", "did you mean --json?"});
    EXPECT_EQ(run(mesh_ball("out.stl", {"--frobnicate"})).err.find("did you mean"), std::string::npos);
}

TEST_F(UsageTest, numbers_out_of_range_are_refused_with_option_value_and_range)
{
    for (const std::string option : {"--size", "--distance", "--floor", "--reach"})
        for (const std::string value : {"0", "-1", "nan", "inf", "wide"})
            expect_wrong_usage(mesh_ball("out.stl", {option, value}), {option, "'" + value + "'", "> 0, mm"});
    for (const std::string value : {"-1", "30.5", "nan"})
        expect_wrong_usage(mesh_ball("out.stl", {"--angle", value}),
                           {"--angle", "'" + value + "'", "from 0 to 30"});
    expect_wrong_usage({"mesh", folder_ / "ball.mha", "-o", folder_ / "out.stl", "--isovalue", "nan"},
                       {"--isovalue", "'nan'", "auto"});
    expect_wrong_usage(mesh_ball("out.stl", {"--size", "1e-9"}), {"--size is 1e-09", "vertices", "at least"});
    for (const std::string value : {"0", "-3", "1.5", "many"})
        expect_wrong_usage(mesh_ball("out.stl", {"--threads", value}),
                           {"--threads", "'" + value + "'", ">= 1"});
    expect_wrong_usage(mesh_ball("out.stl", {"--seed", "-1"}), {"--seed", "'-1'", ">= 0"});
    expect_wrong_usage(mesh_ball("out.stl", {"--max-vertices", "0"}), {"--max-vertices", "'0'", ">= 1"});
    expect_wrong_usage(mesh_ball("out.stl", {"--spacing", "1,2"}), {"--spacing", "'1,2'", "three numbers"});
    expect_wrong_usage(mesh_ball("out.stl", {"--floor", "3", "--size", "2"}),
                       {"--floor is 3", "--size, here 2"});
}

TEST_F(UsageTest, unknown_words_are_refused_with_the_known_ones)
{
    expect_wrong_usage(mesh_ball("out.stl", {"--border", "ajar"}), {"--border", "'ajar'", "closed, open"});
    expect_wrong_usage(mesh_ball("out.stl", {"--inside", "left"}), {"--inside", "auto, above, below"});
    expect_wrong_usage(mesh_ball("out.stl", {"--isolated", "some"}), {"--isolated", "one, all"});
    expect_wrong_usage(mesh_ball("out.stl", {"--progress", "loud"}), {"--progress", "auto, bar, json, none"});
    expect_wrong_usage(mesh_ball("out.stl", {"--frame-of-reference", "xyz"}), {"lps, ras, index"});
    expect_wrong_usage(mesh_ball("out.stl", {"--format", "docx"}), {"docx", "stl"});
    expect_wrong_usage(mesh_ball("out.docx"), {"docx", "stl"});
    expect_wrong_usage(mesh_ball("out.stl", {"--normals"}), {"--normals", ".ply, .obj and .vtp"});
}

TEST_F(UsageTest, options_that_do_not_go_with_the_file_are_refused)
{
    expect_wrong_usage(mesh_ball("out.stl", {"--grid", "density"}), {"--grid", ".vdb"});
    expect_wrong_usage({"mesh", folder_ / "any.vdb", "-o", folder_ / "out.stl", "--frame", "1"},
                       {"--frame", ".vdb"});
    expect_wrong_usage({"info", folder_ / "any.vdb", "--spacing", "1,1,1"}, {"--spacing", ".vdb"});
    expect_wrong_usage(mesh_ball("out.stl", {"--series", "1.2"}),
                       {"--series", "'1.2'", "folder of DICOM files"});
}

TEST_F(UsageTest, one_file_cannot_be_input_and_output)
{
    std::filesystem::copy(folder_ / "ball.mha", folder_ / "ball.stl");
    expect_wrong_usage({"mesh", folder_ / "ball.stl", "-o",
                        folder_ / "../" + folder_.path().filename().string() + "/ball.stl"},
                       {"OUTPUT and INPUT"});
    expect_wrong_usage(mesh_ball("out.stl", {"--summary", folder_ / "out.stl"}), {"--summary and OUTPUT"});
}

TEST_F(UsageTest, a_label_map_needs_an_isovalue)
{
    Phantom labels = ball_phantom();
    labels.field = [](const Point3& p) {
        return distance(p, {11.5, 11.5, 11.5}) > 8.0 ? 0.0 : p.x < 8.0 ? 1.0 : p.x < 15.0 ? 2.0 : 3.0;
    };
    write_phantom(labels, folder_ / "labels.mha");
    expect_wrong_usage({"mesh", folder_ / "labels.mha", "-o", folder_ / "out.stl"},
                       {"label map", "--labels all", "--isovalue", "0.5"});
    const Outcome given =
        run({"mesh", folder_ / "labels.mha", "-o", folder_ / "out.stl", "--isovalue", "0.5"});
    EXPECT_EQ(given.status, 0);
    EXPECT_NE(given.err.find("voroprobe: warning: this looks like a label map"), std::string::npos)
        << given.err;
}

TEST_F(UsageTest, help_and_version_go_to_stdout_and_are_no_failure)
{
    const Outcome version = run({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_EQ(version.out, "voroprobe " VOROPROBE_VERSION "\n");
    EXPECT_EQ(version.err, "");
    EXPECT_EQ(run({"--help"}).status, 0);
    EXPECT_NE(run({"--help"}).out.find("Exit status"), std::string::npos);
}

TEST_F(UsageTest, help_lists_every_option_with_its_default)
{
    const Outcome help = run({"mesh", "--help"});
    EXPECT_EQ(help.status, 0);
    for (const char* option : {"--isovalue",
                               "--inside",
                               "--border",
                               "--size",
                               "--angle",
                               "--distance",
                               "--floor",
                               "--reach",
                               "--isolated",
                               "--max-vertices",
                               "--output",
                               "--format",
                               "--frame-of-reference",
                               "--summary",
                               "--spacing",
                               "--frame",
                               "--series",
                               "--grid",
                               "--progress",
                               "--seed",
                               "--threads",
                               "--quiet",
                               "default 2 m",
                               "default 0.3 v",
                               "default 0.25 v",
                               "default 30",
                               "default lps",
                               "Criteria",
                               "Reading"})
        EXPECT_NE(help.out.find(option), std::string::npos) << option << " is not in the help";
}

} // namespace
} // namespace voroprobe
