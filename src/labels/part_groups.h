#pragma once

#include <cstdint>
#include <vector>

#include "labels/label_survey.h"

namespace voroprobe
{

//! Parts of a label that are meshed together, as their surfaces might otherwise meet.
struct PartGroup
{
    std::vector<std::uint32_t> parts; //!< places in LabelSurvey::parts(), ascending, at least one
    IndexBox box;                     //!< of all of them
};

//! Parts whose boxes, one sample larger on every side, have a sample in common. The surface of a part lies
//! between its samples and their neighbours, so surfaces of different groups are at least a grid edge apart.
//! Ordered by first part. Cost: O(n log n) for n parts that are spread along x.
std::vector<PartGroup> group_parts(const LabelSurvey& survey, const SurveyedLabel& label);

//! Which part of a group the samples of its box belong to, with a margin around them that may reach beyond
//! the border of the volume.
struct PartMask
{
    SampleIndex first;               //!< of the mask, in the volume
    std::array<std::size_t, 3> size; //!< samples along each axis
    std::vector<std::uint32_t> part; //!< 0: none of them; else 1 + the place in PartGroup::parts
    std::size_t part_count;
};

//! Samples around a group's box: the outermost is far outside for any field made of the mask.
inline constexpr int kMaskMargin = 2;

//! Cost: one pass over the samples of the box and the runs of its rows.
PartMask cut_mask(const LabelSurvey& survey, const PartGroup& group);

} // namespace voroprobe
