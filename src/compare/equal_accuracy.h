#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "compare/competition.h"

namespace voroprobe
{

//! How many vertices contestants need to be as near to the scan's surface as the reference is: by the largest
//! two-sided distance, and by the root mean square of it. Every contestant that can be made finer or coarser
//! is run a few times more, and of all its runs the one with the fewest vertices that is as near counts: a
//! number of vertices that is enough, measured and not interpolated. Those that are done and can be run again
//! are run; as report.json has it. Null where the reference is not done. \pre this process has one thread.
nlohmann::ordered_json equal_accuracy(const std::vector<ContestantOutcome>& outcomes, const MeshingTask& task,
                                      const ReferenceSurface& reference, const CompetitionOptions& options);

} // namespace voroprobe
