#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "geometry/affine_transform.h"
#include "mesher/meshing_options.h"

namespace voroprobe
{

//! The size of a voxel, scan units.
struct VoxelScale
{
    double shortest_side;
    double mean_side; //!< side of the cube of equal volume: the geometric mean of the three sides
};

//! Read off the map from the grid frame (scan units) to index coordinates, which every input has.
VoxelScale voxel_scale(const AffineTransform& source_index_from_grid);

//! Criteria the user gave; what is unset follows the voxels.
struct RequestedCriteria
{
    std::optional<double> size = std::nullopt;     //!< mm, > 0
    std::optional<double> distance = std::nullopt; //!< mm, > 0
    std::optional<double> floor = std::nullopt;    //!< mm, > 0
    std::optional<double> reach = std::nullopt;    //!< mm, > 0
    double angle_deg = 30.0;                       //!< in [0, 30]
};

//! The criteria given, and for the others:
//! - size: 2 mean sides. A bound on density; on anisotropic scans (0.5 x 0.5 x 3 mm) twice the shortest side
//! would give several
//!   vertices per voxel, and where the surface asks for them the distance criterion puts them anyway;
//! - distance: 0.3 shortest sides, because the finest detail a scan can hold is as wide as its shortest side;
//! - floor: 0.25 shortest sides, but at most half the size asked for, or the floor would overrule it;
//! - reach: 1 shortest side.
//! \throw UsageError where the floor given is larger than the size.
MeshingOptions meshing_options(const RequestedCriteria& requested, const VoxelScale& voxel);

} // namespace voroprobe
