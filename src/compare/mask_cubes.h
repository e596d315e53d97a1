#pragma once

#include "geometry/vec3.h"
#include "labels/part_groups.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! How far the usual way is gone.
enum class CubesFinish
{
    kRough,    //!< VTK's discrete marching cubes: the staircase of the voxels, halfway between them
    kSmoothed, //!< then windowed-sinc smoothing: 20 rounds, pass band 0.1
    kDecimated //!< then quadric decimation to a quarter of the faces, as nii2mesh and 3D Slicer do
};

//! What the usual way makes of the mask of a label, all parts of it together. Frame: that of the mask, its
//! first sample at the origin; equal points are one vertex. `spacing`: scan units.
TriangleMesh cubes_of_mask(const PartMask& mask, const Vec3& spacing, CubesFinish finish);

} // namespace voroprobe
