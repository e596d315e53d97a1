#include "compare/equal_accuracy.h"

#include <algorithm>
#include <cstddef>

#include <gtest/gtest.h>

#include "compare/one_thread.h"
#include "compared_phantom.h"

namespace voroprobe
{

namespace
{

//! The fewest vertices of the trials that are as near as `target`; null where none is.
nlohmann::ordered_json fewest(const nlohmann::ordered_json& trials, const char* key, double target)
{
    nlohmann::ordered_json best;
    for (const auto& trial : trials)
        if (trial.at(key) <= target && (best.is_null() || trial.at("vertices") < best))
            best = trial.at("vertices");
    return best;
}

void expect_best(const nlohmann::ordered_json& sweep, const char* answer, const char* key,
                 const nlohmann::ordered_json& reference)
{
    const auto best = fewest(sweep.at("trials"), key, reference.at(key));
    ASSERT_EQ(sweep.at(answer).is_null(), best.is_null()) << sweep.dump(1);
    if (best.is_null())
        return;
    EXPECT_EQ(sweep.at(answer).at("vertices"), best);
    EXPECT_DOUBLE_EQ(sweep.at(answer).at("of_reference"),
                     best.get<double>() / reference.at("vertices").get<double>());
}

TEST(EqualAccuracy, what_counts_is_the_smallest_mesh_tried_that_is_as_near_as_marching_cubes)
{
    const OneThread one_thread;
    const ComparedPhantom phantom =
        compared_phantom(torus_phantom({16.1, 16.2, 9.3}, 10.0, 4.0), {33, 33, 19});
    const CompetitionOptions options{.measuring = {.mesh_samples = 4000}, .at_once = 2, .pictures = false};
    std::vector<ContestantEntry> entries = all_contestants();
    std::erase_if(entries, [](const ContestantEntry& entry)
                  { return entry.name != kOurs && entry.name != kReference && entry.name != "decimated"; });
    const auto outcomes = compete(entries, phantom.task, phantom.reference, options);
    const auto report = equal_accuracy(outcomes, phantom.task, phantom.reference, options);

    ASSERT_EQ(report.at("contestants").size(), 2U);
    for (const auto& sweep : report.at("contestants"))
    {
        expect_best(sweep, "at_equal_max", "max_mm", report.at("reference"));
        expect_best(sweep, "at_equal_rms", "rms_mm", report.at("reference"));
        EXPECT_GE(sweep.at("trials").size(), 3U);
        EXPECT_EQ(sweep.at("trials").at(0).at("factor"), 1.0);
    }
    // A mesh of a smooth torus gets the nearer the finer it is: the search ends where ours is as near as the
    // reference, or where another step would take more than twice its vertices.
    const auto& ours = report.at("contestants").at(0);
    std::size_t most = 0;
    for (const auto& trial : ours.at("trials"))
        most = std::max(most, trial.at("vertices").get<std::size_t>());
    const auto of_reference = report.at("reference").at("vertices").get<double>();
    EXPECT_TRUE(!ours.at("at_equal_max").is_null() || static_cast<double>(most) > 1.9 * of_reference) << most;
}

TEST(EqualAccuracy, trials_that_run_when_the_time_is_used_count_and_no_more_are_begun)
{
    const OneThread one_thread;
    const ComparedPhantom phantom =
        compared_phantom(torus_phantom({16.1, 16.2, 9.3}, 10.0, 4.0), {33, 33, 19});
    const CompetitionOptions options{.measuring = {.mesh_samples = 1000},
                                     .sweep_seconds = 1e-9, // less than any trial takes
                                     .at_once = 2,
                                     .pictures = false};
    std::vector<ContestantEntry> entries = all_contestants();
    std::erase_if(entries, [](const ContestantEntry& entry)
                  { return entry.name != kOurs && entry.name != kReference && entry.name != "decimated"; });
    const auto outcomes = compete(entries, phantom.task, phantom.reference, options);
    const auto report = equal_accuracy(outcomes, phantom.task, phantom.reference, options);

    const auto& ours = report.at("contestants").at(0);
    EXPECT_EQ(ours.at("name"), kOurs); // comes first
    EXPECT_EQ(ours.at("trials").size(), 1U + options.at_once);
    const auto& others = report.at("contestants").at(1);
    EXPECT_EQ(others.at("trials").size(), 1U);
    EXPECT_EQ(others.at("ended_by"), "the time for it was over");
}

TEST(EqualAccuracy, there_is_none_without_the_reference)
{
    const OneThread one_thread;
    const ComparedPhantom phantom = compared_phantom(sphere_phantom({8, 8, 8}, 5.0), {17, 17, 17});
    EXPECT_TRUE(equal_accuracy({}, phantom.task, phantom.reference, {}).is_null());
}

} // namespace

} // namespace voroprobe
