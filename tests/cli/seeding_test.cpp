#include <nlohmann/json.hpp>

#include "program_fixture.h"

namespace voroprobe
{
namespace
{

using nlohmann::json;
using program::Outcome;
using program::run;

//! Options of "Finding the components", on two balls of different sizes far apart.
class SeedingTest : public ProgramTest
{
protected:
    static constexpr const char* kTwoBalls =
        "min((x+3)^2+y^2+z^2-1, (x-3)^2+(y-1)^2+z^2-0.04)"; // radii 1 and 0.2

    static std::vector<std::string> with(std::vector<std::string> arguments,
                                         const std::vector<std::string>& more)
    {
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    [[nodiscard]] std::vector<std::string> two_balls(const std::vector<std::string>& more) const
    {
        return with({"mesh", "--implicit", kTwoBalls, "--domain", "box:-6,-4,-4,6,4,4", "-o",
                     folder_ / "out.stl", "--summary", folder_ / "out.json", "--size", "0.2", "--distance",
                     "0.02", "--floor", "0.01"},
                    more);
    }

    json summary_of(const std::vector<std::string>& more)
    {
        last_ = run(two_balls(more));
        EXPECT_EQ(last_.status, 0) << last_.err;
        return json::parse(program::read_text(folder_ / "out.json"));
    }

    void expect_refusal(const std::vector<std::string>& arguments, int status, const std::string& words)
    {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_TRUE(is_one_error_line(outcome.err)) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << words << " is not in: " << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "out.stl"));
    }

    [[nodiscard]] std::string seeds(const std::string& text) const
    {
        program::write_text(folder_ / "seeds.txt", text);
        return folder_ / "seeds.txt";
    }

    Outcome last_;
};

TEST_F(SeedingTest, probing_finds_both_balls_and_the_summary_tells_how)
{
    const json summary = summary_of({"--reach", "0.15"});
    EXPECT_EQ(summary["mesh"]["components"], 2);
    const json& parameters = summary["parameters"];
    EXPECT_EQ(parameters["seeding"], "probe"); // a formula has no inventory
    EXPECT_EQ(parameters["component_radius_mm"], 0.15);
    EXPECT_EQ(parameters["theorem"], false);
    for (const char* unused : {"random_points", "components", "seeds", "max_seconds"})
        EXPECT_TRUE(parameters.at(unused).is_null()) << unused;
    for (const char* key : {"seeds_off_surface", "seeds_passed_over", "voronoi_cells_probed", "probe_hits",
                            "probe_hits_passed_over"})
        EXPECT_TRUE(summary["seeding"].at(key).is_number_unsigned()) << key;
    EXPECT_GT(summary["seeding"]["voronoi_cells_probed"], 0);
}

TEST_F(SeedingTest, a_larger_component_radius_takes_fewer_probes)
{
    const json fine = summary_of({"--reach", "0.05"});
    const json coarse = summary_of({"--reach", "0.05", "--component-radius", "0.15"});
    EXPECT_EQ(coarse["mesh"]["components"], 2);
    EXPECT_EQ(coarse["parameters"]["component_radius_mm"], 0.15);
    EXPECT_LT(coarse["oracle_queries"]["probing"], fine["oracle_queries"]["probing"]);
}

TEST_F(SeedingTest, known_seeds_and_their_number_spare_all_probes)
{
    const json summary = summary_of({"--seeds", seeds("# two\n-2 0 0\n\n3 1.2 0\n"), "--components", "2"});
    EXPECT_EQ(summary["mesh"]["components"], 2);
    EXPECT_EQ(summary["oracle_queries"]["probing"], 0);
    EXPECT_EQ(summary["parameters"]["components"], 2);
    EXPECT_EQ(summary["parameters"]["seeds"], folder_ / "seeds.txt");
    EXPECT_EQ(last_.err, "");
}

TEST_F(SeedingTest, seeds_off_the_surface_are_counted_and_warned_of)
{
    const json summary = summary_of({"--seeds", seeds("0 0 0\n-2 0 0\n100 0 0\n"), "--reach", "0.15"});
    EXPECT_EQ(summary["mesh"]["components"], 2);
    EXPECT_EQ(summary["seeding"]["seeds_off_surface"], 2);
    EXPECT_NE(last_.err.find("warning: 2 points of --seeds"), std::string::npos) << last_.err;
}

TEST_F(SeedingTest, fewer_components_than_told_are_warned_of)
{
    const json summary = summary_of({"--components", "3", "--reach", "0.15"});
    EXPECT_EQ(summary["mesh"]["components"], 2);
    EXPECT_NE(last_.err.find("warning: --components is 3, but the mesh has 2"), std::string::npos)
        << last_.err;
}

TEST_F(SeedingTest, rays_are_random_and_their_seed_counts)
{
    const json summary = summary_of({"--seeding", "random:30", "--seed", "5"});
    EXPECT_EQ(summary["parameters"]["seeding"], "random");
    EXPECT_EQ(summary["parameters"]["random_points"], 30);
    const std::string first = program::read_text(folder_ / "out.stl");
    summary_of({"--seeding", "random:30", "--seed", "6"});
    EXPECT_NE(program::read_text(folder_ / "out.stl"), first);
    summary_of({"--seeding", "random:30", "--seed", "5"});
    EXPECT_EQ(program::read_text(folder_ / "out.stl"), first);
}

TEST_F(SeedingTest, seeds_that_cannot_be_read_are_input_errors_with_the_line)
{
    expect_refusal(two_balls({"--seeds", folder_ / "absent.txt"}), 3, "absent.txt");
    expect_refusal(two_balls({"--seeds", seeds("1 2 3\n1 2\n")}), 3, "line 2");
    expect_refusal(two_balls({"--seeds", seeds("1 2 3 4\n")}), 3, "line 1");
    expect_refusal(two_balls({"--seeds", seeds("1 2 nan\n")}), 3, "line 1");
    expect_refusal(two_balls({"--seeds", seeds("# none\n\n")}), 3, "holds no point");
}

TEST_F(SeedingTest, values_that_make_no_sense_are_wrong_usage)
{
    for (const std::string value : {"guess", "random", "random:", "random:0", "random:1.5", "random:-3"})
        expect_refusal(two_balls({"--seeding", value}), 2, "--seeding");
    expect_refusal(two_balls({"--seeding", "random:1000000000000"}), 2, "up to 1000000");
    for (const std::string value : {"0", "-1", "many"})
        expect_refusal(two_balls({"--components", value}), 2, "--components");
    for (const std::string value : {"0", "-1", "nan", "soon"})
        expect_refusal(two_balls({"--max-seconds", value}), 2, "--max-seconds");
    for (const std::string value : {"0", "-1", "nan", "inf"})
        expect_refusal(two_balls({"--reach", value}), 2, "--reach");
    expect_refusal(two_balls({"--reach", "0.2", "--component-radius", "0.1"}), 2, "at least --reach");
    expect_refusal(two_balls({"--theorem"}), 2, "--size is 0.2");
}

TEST_F(SeedingTest, a_reach_that_would_take_for_ever_is_refused_or_stopped_in_time)
{
    expect_refusal(two_balls({"--reach", "1e-9"}), 2, "reach");
    const Outcome outcome = run(two_balls({"--reach", "1e-4", "--max-seconds", "1"}));
    EXPECT_EQ(outcome.status, 6) << outcome.err;
    EXPECT_NE(outcome.err.find("--max-seconds 1"), std::string::npos) << outcome.err;
}

TEST_F(SeedingTest, a_budget_in_time_gives_a_flagged_partial_result)
{
    const Outcome outcome =
        run(with(two_balls({"--max-seconds", "0.05"}), {"--angle", "30", "--reach", "0.01"}));
    EXPECT_EQ(outcome.status, 6) << outcome.err;
    EXPECT_TRUE(is_one_error_line(outcome.err)) << outcome.err;
    EXPECT_NE(outcome.err.find("--max-seconds 0.05"), std::string::npos) << outcome.err;
}

TEST_F(SeedingTest, the_theorem_sets_the_size_and_holds_on_a_ball)
{
    const Outcome outcome =
        run({"mesh", "--implicit", "x^2+y^2+z^2-1", "--domain", "ball:0,0,0,1.5", "-o", folder_ / "out.stl",
             "--summary", folder_ / "out.json", "--reach", "0.9", "--theorem"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const json summary = json::parse(program::read_text(folder_ / "out.json"));
    EXPECT_EQ(summary["parameters"]["theorem"], true);
    EXPECT_NEAR(summary["parameters"]["size_mm"].get<double>(), 0.091 * 0.9, 1e-12);
    EXPECT_EQ(summary["parameters"]["isolated"], "one");
    EXPECT_EQ(summary["mesh"]["euler_characteristic"], 2);
}

} // namespace
} // namespace voroprobe
