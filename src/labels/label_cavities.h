#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "labels/label_survey.h"

namespace voroprobe
{

//! Samples of one cavity in the row (., j, k), from `first` to before `end`.
struct CavityRun
{
    std::int32_t j;
    std::int32_t k;
    std::int32_t first;
    std::int32_t end;
    std::uint32_t cavity; //!< from 0, in the order of their first samples
};

//! What the voxels of a label enclose of everything else: voxels that are not the label's, joined through
//! faces (6 neighbours), and cut off from the outside. `label`: its place in survey.labels(). In the order of
//! memory. Cost: near-linear in the runs of the rows of the label's box.
std::vector<CavityRun> find_cavities(const LabelSurvey& survey, std::uint32_t label);

std::size_t count_cavities(const LabelSurvey& survey, std::uint32_t label);

} // namespace voroprobe
