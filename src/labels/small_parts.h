#pragma once

#include <cstdint>
#include <vector>

#include "labels/cavity_labels.h"

namespace voroprobe
{

//! Parts of few voxels that touch no other part standing for the same label, nor background where they stand
//! for that: they may grow to the volume of their voxels without coming to join it. Places in
//! apart.survey.parts(), ascending. Cost: O(runs).
std::vector<std::uint32_t> small_parts_alone(const CavityLabels& apart);

} // namespace voroprobe
