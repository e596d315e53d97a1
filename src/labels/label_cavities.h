#pragma once

#include <cstddef>
#include <cstdint>

#include "labels/label_survey.h"

namespace voroprobe
{

//! What the voxels of a label enclose of everything else: voxels that are not the label's, joined through
//! faces (6 neighbours), and cut off from the outside. `label`: its place in survey.labels(). Cost:
//! near-linear in the runs of the rows of the label's box.
std::size_t count_cavities(const LabelSurvey& survey, std::uint32_t label);

} // namespace voroprobe
