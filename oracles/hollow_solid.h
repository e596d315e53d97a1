#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "oracles/surface_oracle.h"
#include "volume/inventory.h"

namespace voroprobe
{

//! How to hollow a body out; lengths in mm.
struct HollowOptions
{
    double wall;                 //!< thickness to leave, > 0
    double drain_diameter = 0.0; //!< of one vertical hole down from the lowest point of each hollow; 0: none
    double voxel;                //!< of the level set, > 0 and at most half the wall
};

//! A body without what lies deeper than its wall, and with a drain for each hollow.
struct HollowSolid
{
    std::unique_ptr<SurfaceOracle> oracle;      //!< frame: the mesh's
    std::shared_ptr<const Inventory> inventory; //!< of its surfaces
    std::size_t hollows = 0;
    std::vector<Point3> drains; //!< lowest point of each hollow, where a drain begins
};

//! By level sets on voxels: what is finer than a voxel goes, and the wall is as thick as asked for to about
//! half a voxel. \pre the mesh is closed, manifold and oriented. Memory: some 20 bytes per voxel within the
//! wall of the surface. \throw UsageError where an option is out of its range, this machine has less memory
//! than that, or the body is too thin to hollow out.
HollowSolid hollow_out(const TriangleMesh& mesh, const HollowOptions& options);

} // namespace voroprobe
