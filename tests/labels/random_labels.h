#pragma once

#include <array>
#include <cstdint>

#include "labels/label_survey.h"
#include "volume/volume.h"

namespace voroprobe
{

//! A label map of `labels` labels and background, on a grid of 1 mm: a few blobs each, and some single voxels
//! strewn over all, so that there are specks, contacts at corners, cavities, and labels at the border.
Volume random_labels(const std::array<std::size_t, 3>& size, std::uint16_t labels, std::uint64_t seed);

//! Voxels that are taken for connected: those that share a face, or a face, an edge or a corner.
enum class Neighbours
{
    kFaces, //!< 6
    kAll    //!< 26
};
//! Connected components of the samples for which `belongs` holds, one flood each.
std::size_t count_components(const std::array<std::size_t, 3>& size, const std::vector<bool>& belongs,
                             Neighbours neighbours);

} // namespace voroprobe
