#pragma once

#include <memory>

#include "geometry/affine_transform.h"
#include "oracles/surface_oracle.h"
#include "volume/inventory.h"

namespace voroprobe
{

//! What meshes are held against: the isosurface of the trilinear interpolant of the scan, its surfaces one by
//! one.
struct ReferenceSurface
{
    std::shared_ptr<const SurfaceOracle> oracle; //!< frame: grid
    std::shared_ptr<const Inventory> inventory;
    AffineTransform world_from_grid; //!< places are told in the world, LPS, mm
    double voxel; //!< side of the cube of a voxel's volume, mm: the unit of distances in voxels

    //! All surfaces of the scan, world.
    [[nodiscard]] Box3 box_world() const
    {
        Box3 box;
        for (const ScanSurface& surface : inventory->surfaces())
            for (unsigned corner = 0; corner < 8; ++corner)
                box.include(world_from_grid * Point3{(corner & 1U ? surface.box.max : surface.box.min).x,
                                                     (corner & 2U ? surface.box.max : surface.box.min).y,
                                                     (corner & 4U ? surface.box.max : surface.box.min).z});
        return box;
    }
};

//! How closely meshes are looked at.
struct MeasuringOptions
{
    std::size_t mesh_samples = 20000; //!< points of a mesh; half as many of the scan
    double angle_bound_deg = 30.0;    //!< faces below it are counted; in [0, 60]
};

} // namespace voroprobe
