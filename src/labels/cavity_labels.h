#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "labels/label_partition.h"
#include "labels/label_survey.h"

namespace voroprobe
{

//! A label map in which what lies in the cavities of a label has labels of its own.
struct CavityLabels
{
    LabelSurvey survey;

    //! By PartitionLabel of `survey`, the label of the label map that it is a piece of: its place in
    //! LabelSurvey::labels(), plus one; 0 for background.
    std::vector<PartitionLabel> stands_for;

    //! By PartitionLabel of `survey`, the cavities it lies in: the label around, named as above, and its
    //! cavity (CavityRun).
    std::vector<std::map<PartitionLabel, std::uint32_t>> cavities_around;
};

//! The label map with the labels asked for and nothing else. A bit of background or of a label in a cavity of
//! another label becomes a label of its own, so that it does not join the rest of it at edges and corners of
//! voxels, through the wall of the cavity. `labels`: places in survey.labels(). Cost: O(samples), 4 bytes
//! each while it is made, and the boxes of the labels.
CavityLabels label_cavities_apart(const LabelSurvey& survey, std::span<const std::uint32_t> labels);

} // namespace voroprobe
