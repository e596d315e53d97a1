#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "program_fixture.h"

namespace voroprobe
{
namespace
{

using program::run;

class ProgressTest : public ProgramTest
{
};

TEST_F(ProgressTest, json_is_one_object_a_line_with_phase_and_counts)
{
    const auto outcome = run(mesh_ball("out.stl", {"--progress", "json"}));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    std::set<std::string> phases;
    std::istringstream lines(outcome.err);
    for (std::string line; std::getline(lines, line);)
    {
        const auto report = nlohmann::json::parse(line);
        phases.insert(report.at("phase").get<std::string>());
        EXPECT_TRUE(report.at("vertices").is_number_unsigned());
        EXPECT_TRUE(report.at("bad_facets_left").is_number_unsigned());
        EXPECT_GE(report.at("vertices_per_second").get<double>(), 0.0);
        EXPECT_GE(report.at("seconds").get<double>(), 0.0);
    }
    for (const char* phase : {"read", "refinement", "write"})
        EXPECT_TRUE(phases.contains(phase)) << phase;
}

TEST_F(ProgressTest, bar_shows_phase_vertices_bad_facets_and_rate_and_is_wiped_at_the_end)
{
    const auto outcome = run(mesh_ball("out.stl", {"--progress", "bar", "--size", "0.2"}));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    for (const char* part : {"[", "refinement", " vertices, ", " bad facets left, ", "/s"})
        EXPECT_NE(outcome.err.find(part), std::string::npos) << part;
    EXPECT_TRUE(outcome.err.ends_with("\r\x1b[K")) << outcome.err;
}

TEST_F(ProgressTest, auto_and_none_say_nothing_where_stderr_is_no_terminal)
{
    EXPECT_EQ(run(mesh_ball("out.stl")).err, "");
    EXPECT_EQ(run(mesh_ball("out.stl", {"--progress", "none"})).err, "");
}

TEST_F(ProgressTest, quiet_leaves_stdout_empty)
{
    EXPECT_EQ(run(mesh_ball("out.stl", {"-q"})).out, "");
    EXPECT_EQ(run(mesh_ball("out.stl", {"--quiet"})).out, "");
    EXPECT_NE(run(mesh_ball("out.stl")).out, "");
}

} // namespace
} // namespace voroprobe
