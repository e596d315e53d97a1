#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "io/label_table.h"

namespace voroprobe
{

//! A segment of a segmentation by 3D Slicer. Segments that overlap lie in different layers.
struct Segment
{
    std::size_t layer = 0; //!< ReadOptions::frame reads it
    LabelEntry entry;      //!< its number within the layer, name and colour
};

//! The segments that a .seg.nrrd file tells of, by its keys SegmentN_LabelValue, _Layer, _Name and _Color;
//! none where the file is no NRRD file or has no such keys. Files of older versions of Slicer give neither
//! layers nor label values: there segment N is label 1 of layer N. \throw InputError where a key is not what
//! it should be.
std::vector<Segment> read_segments(const std::filesystem::path& path);

} // namespace voroprobe
