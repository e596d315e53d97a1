#pragma once

#include "compare/label_contestant.h"
#include "compare/reference_surface.h"
#include "labels/part_groups.h"

//! A label by itself: its mask, and the frame of that.
namespace voroprobe
{

//! All parts of a label. `label`: its place in LabelSurvey::labels().
PartMask mask_of_label(const LabelTask& task, std::uint32_t label);

//! The mask's first sample is the origin of its frame.
AffineTransform grid_from_mask(const LabelTask& task, const PartMask& mask);

//! The staircase of the label's voxels, halfway between those inside and those outside: where the trilinear
//! interpolant of the mask, 0 and 1, is a half. Frame: that of the mask. Cost: passes over its samples.
ReferenceSurface halfway_surface(const LabelTask& task, const PartMask& mask);

//! Samples of a box, half a voxel more on every side, world.
Box3 world_box(const LabelTask& task, const IndexBox& box);

} // namespace voroprobe
