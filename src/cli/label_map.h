#pragma once

#include <cstddef>

#include "volume/statistics.h"
#include "volume/volume.h"

namespace voroprobe
{

//! Share of equal values among neighbours along x that are not both the most frequent value (the background),
//! in [0, 1]. About a million pairs are looked at, whole rows spread over the volume. 0 where there is no
//! such pair.
double equal_neighbor_share(const Volume& volume);

//! Whether the samples look like names of regions rather than measurements: whole numbers, 3 to 4096 of them,
//! and most neighbours equal. Between names there is nothing to interpolate, so no isovalue can be guessed. A
//! mask of two values is not counted: halfway between them is right.
bool looks_like_label_map(const Volume& volume, const VolumeStatistics& statistics);

//! Whether whole numbers that were called labels are rather measurements: many different ones, and neighbours
//! hardly ever equal. Labels of a voxel or two each look like that as well.
bool looks_like_scan(const Volume& volume, std::size_t labels);

} // namespace voroprobe
