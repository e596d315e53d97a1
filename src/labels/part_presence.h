#pragma once

#include <vector>

#include "geometry/vec3.h"
#include "labels/part_groups.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! For each part of a mask, by its place in PartGroup::parts, whether a mesh made by anyone has it: whether a
//! closed piece that winds outward has most of its corners next to that part's voxels. A part that melted
//! into another has none of its own.
//!
//! Frame: that of the mask, its first sample at the origin. `spacing`: scan units. \pre equal points of the
//! mesh are one vertex. Cost: 27 samples for each corner of each face.
std::vector<bool> parts_present(const TriangleMesh& mesh, const PartMask& mask, const Vec3& spacing);

} // namespace voroprobe
