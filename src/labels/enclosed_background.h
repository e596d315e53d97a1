#pragma once

#include <cstdint>
#include <span>

#include "labels/label_survey.h"

namespace voroprobe
{

//! The label map with the labels asked for and nothing else, where each bit of background that a single label
//! encloses, joined through faces (6 neighbours), is a label of its own: kept like one, and not joined with
//! what it touches at edges and corners of voxels. The n-th label of it is the n-th of `labels` (places in
//! survey.labels()), with its parts in the same order; those of the background follow. Cost: O(samples), 4
//! bytes each while it is made.
LabelSurvey with_enclosed_background(const LabelSurvey& survey, std::span<const std::uint32_t> labels);

} // namespace voroprobe
