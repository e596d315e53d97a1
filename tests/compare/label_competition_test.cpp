#include "compare/label_competition.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "compare/contestant_list.h"
#include "compare/one_thread.h"
#include "label_map_phantom.h"

namespace voroprobe
{

namespace
{

class LabelCompetition : public testing::Test
{
protected:
    OneThread one_thread_; // contestants are forks of the test
    LabelTask task_ = three_blocks();
    CompetitionOptions options_{
        .measuring = {.mesh_samples = 1000}, .contestant_seconds = 60.0, .at_once = 2, .pictures = false};
};

TEST_F(LabelCompetition, ours_has_every_part_with_the_volume_of_its_voxels)
{
    const auto outcomes = compete_on_labels(all_label_contestants(), task_, options_);
    ASSERT_EQ(outcomes.size(), 4U);
    for (const ContestantOutcome& outcome : outcomes)
    {
        ASSERT_TRUE(outcome.done()) << outcome.report.dump();
        EXPECT_EQ(outcome.report.at("surfaces").at("expected"), 3);
        EXPECT_EQ(outcome.report.at("labels").at("count"), 2);
        EXPECT_FALSE(outcome.view.empty());
    }
    const auto& ours = outcomes.front();
    EXPECT_EQ(ours.entry.name, kOurs);
    EXPECT_EQ(ours.report.at("surfaces").at("meshed"), 3);
    EXPECT_LE(ours.report.at("labels").at("largest_volume_change"), task_.options.volume_tolerance);
    EXPECT_EQ(ours.report.at("labels").at("not_closed_manifold"), 0);
    EXPECT_EQ(ours.report.at("topology").at("self_intersections"), 0);
    // A quarter of the faces of the step before.
    EXPECT_NEAR(outcomes[3].report.at("faces").get<double>() / outcomes[2].report.at("faces").get<double>(),
                0.25, 0.02);
}

TEST_F(LabelCompetition, one_that_fails_is_an_outcome_with_a_reason)
{
    std::vector<LabelContestantEntry> entries = all_label_contestants();
    entries.resize(2);
    entries[1].make = [](const LabelTask&) -> std::unique_ptr<LabelContestant>
    { throw std::runtime_error("it is not installed"); };
    const auto outcomes = compete_on_labels(entries, task_, options_);
    EXPECT_TRUE(outcomes[0].done());
    EXPECT_EQ(outcomes[1].report.at("reason"), "it is not installed");
}

} // namespace

} // namespace voroprobe
