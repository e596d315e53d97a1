#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "compare/competition_options.h"
#include "compare/contest_outcome.h"
#include "compare/contestant_list.h"
#include "compare/measurement.h"
#include "compare/process_pool.h"
#include "compare/reference_surface.h"

namespace voroprobe
{

//! Runs every contestant in a process of its own, and measures it there. Ours is to be the first; contestants
//! that are told how fine ours is wait for it. One that fails is an outcome with a reason. Order: that of
//! `entries`. \pre this process has one thread.
std::vector<ContestantOutcome> compete(const std::vector<ContestantEntry>& entries, const MeshingTask& task,
                                       const ReferenceSurface& reference, const CompetitionOptions& options);

//! The task with the targets that ours sets. \pre ours is done.
MeshingTask with_targets(const MeshingTask& task, const nlohmann::ordered_json& ours);

} // namespace voroprobe
