#pragma once

#include <string_view>

#include "geometry/affine_transform.h"

namespace voroprobe
{

//! Coordinates that vertices are written in.
enum class OutputFrame
{
    kLps,  //!< mm; x to the patient's left, y to the back, z to the head: ITK, DICOM
    kRas,  //!< mm; x to the right, y to the front, z to the head: NIfTI, scanners' own
    kIndex //!< voxels: index coordinates of the file
};

//! "lps", "ras" or "index".
std::string_view frame_name(OutputFrame frame);

//! Unit of lengths in the frame: "mm" or "voxel".
std::string_view frame_unit(OutputFrame frame);

//! Where the grid frame of an input lies; every input has both.
struct GridPlacement
{
    AffineTransform world_from_grid;        //!< world is LPS, mm
    AffineTransform source_index_from_grid; //!< to the file's index coordinates
};

AffineTransform output_from_grid(OutputFrame frame, const GridPlacement& placement);

} // namespace voroprobe
