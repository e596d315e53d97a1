#pragma once

#include <string>

#include "cli/surface_input.h"
#include "geometry/box3.h"
#include "oracles/implicit_domain.h"

namespace voroprobe
{

//! What stands for the side of a voxel where there are no voxels: a hundredth of the diagonal of the object's
//! box, or of a formula's domain. The defaults of the criteria follow it.
double grain_size(const Box3& box);

//! "box:x0,y0,z0,x1,y1,z1" or "ball:cx,cy,cz,r". \throw UsageError as parse_number.
ImplicitDomain parse_domain(const std::string& text);

//! Whether the request is for a formula, a triangle mesh (.stl .ply .obj .off .vtp .3mf) or a point cloud
//! (.xyz), and not for a volume.
bool is_shape(const SurfaceRequest& request);

//! \throw UsageError where the request says something that goes with volumes only, or lacks what it needs.
void check_shape_request(const SurfaceRequest& request);

//! The surface of a formula, a triangle mesh or a point cloud. Its frame is that of the formula or file,
//! millimetres, LPS. \throw as the readers and the oracles.
SurfaceInput load_shape(const SurfaceRequest& request);

} // namespace voroprobe
