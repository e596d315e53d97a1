#pragma once

#include <vector>

#include "compare/competition_options.h"
#include "compare/contest_outcome.h"
#include "compare/label_contestant.h"

namespace voroprobe
{

//! Runs every contestant on the label map, in a process of its own, and measures it there. One that fails is
//! an outcome with a reason. Order: that of `entries`. \pre this process has one thread.
std::vector<ContestantOutcome> compete_on_labels(const std::vector<LabelContestantEntry>& entries,
                                                 const LabelTask& task, const CompetitionOptions& options);

} // namespace voroprobe
