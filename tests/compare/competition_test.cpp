#include "compare/competition.h"

#include <cstdlib>
#include <stdexcept>

#include <gtest/gtest.h>
#include <unistd.h>

#include "compare/one_thread.h"
#include "compared_phantom.h"

namespace voroprobe
{

namespace
{

ContestantEntry entry(const std::string& name, Knob knob,
                      std::function<std::unique_ptr<Contestant>(const MeshingTask&)> make)
{
    return {name, name, "for a test", knob, std::move(make)};
}

class CompetitionOnASphere : public testing::Test
{
protected:
    std::vector<ContestantOutcome> compete_with(const std::vector<ContestantEntry>& entries)
    {
        return compete(entries, phantom_.task, phantom_.reference, options_);
    }

    OneThread one_thread_; // contestants are forks of the test
    ComparedPhantom phantom_ = compared_phantom(sphere_phantom({12.1, 12.2, 12.3}, 8.0), {25, 25, 25});
    CompetitionOptions options_{
        .measuring = {.mesh_samples = 1000}, .contestant_seconds = 20.0, .at_once = 2, .pictures = false};
};

TEST_F(CompetitionOnASphere, contestants_come_in_their_order_with_all_that_was_measured)
{
    const auto outcomes = compete_with({entry(kOurs, Knob::kCriteria, make_voroprobe),
                                        entry("decimated", Knob::kTargetVertices, make_decimated),
                                        entry(kReference, Knob::kNone, make_marching_cubes)});
    ASSERT_EQ(outcomes.size(), 3U);
    for (const ContestantOutcome& outcome : outcomes)
    {
        ASSERT_TRUE(outcome.done()) << outcome.report.dump();
        EXPECT_EQ(outcome.report.at("surfaces").at("meshed"), 1);
        EXPECT_FALSE(outcome.view.empty());
        EXPECT_GT(outcome.report.at("time").at("cpu_seconds"), 0.0);
    }
    const double ours = outcomes[0].report.at("vertices");
    EXPECT_NEAR(outcomes[1].report.at("vertices").get<double>() / ours, 1.0, 0.05);
}

TEST_F(CompetitionOnASphere, failures_are_outcomes_with_a_reason_and_the_others_come)
{
    options_.contestant_seconds = 2.0;
    const auto throws = [](const MeshingTask&) -> std::unique_ptr<Contestant>
    { throw std::runtime_error("it is not installed"); };
    const auto crashes = [](const MeshingTask&) -> std::unique_ptr<Contestant> { std::abort(); };
    const auto hangs = [](const MeshingTask&) -> std::unique_ptr<Contestant>
    {
        pause();
        return nullptr;
    };
    const auto makes_nothing = [](const MeshingTask&) { return make_given({}); };
    const auto outcomes = compete_with(
        {entry(kReference, Knob::kNone, make_marching_cubes), entry("throws", Knob::kNone, throws),
         entry("crashes", Knob::kNone, crashes), entry("hangs", Knob::kNone, hangs),
         entry("makes_nothing", Knob::kNone, makes_nothing)});
    EXPECT_TRUE(outcomes[0].done());
    EXPECT_EQ(outcomes[1].report.at("reason"), "it is not installed");
    EXPECT_NE(outcomes[2].report.at("reason").get<std::string>().find("signal"), std::string::npos);
    EXPECT_EQ(outcomes[3].report.at("reason"), "not done after 2 s");
    EXPECT_EQ(outcomes[4].report.at("reason"), "it made no face");
}

TEST_F(CompetitionOnASphere, those_that_wait_for_ours_fail_with_it)
{
    const auto throws = [](const MeshingTask&) -> std::unique_ptr<Contestant>
    { throw std::runtime_error("no"); };
    const auto outcomes = compete_with(
        {entry(kOurs, Knob::kCriteria, throws), entry("decimated", Knob::kTargetVertices, make_decimated)});
    EXPECT_FALSE(outcomes[1].done());
    EXPECT_NE(outcomes[1].report.at("reason").get<std::string>().find("Voroprobe"), std::string::npos);
}

} // namespace

} // namespace voroprobe
