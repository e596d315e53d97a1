#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/affine_transform.h"
#include "oracles/surface_oracle.h"
#include "oracles/trilinear_oracle.h"
#include "volume/height_field.h"
#include "volume/inventory.h"

namespace voroprobe
{

//! A sparse OpenVDB grid, kept sparse, and what there is to say about it.
struct VdbSurface
{
    std::unique_ptr<SurfaceOracle> oracle;      //!< frame: voxel size times index, axes along the grid
    std::shared_ptr<const HeightField> heights; //!< what it is the zero set of; frame: the oracle's
    std::shared_ptr<const Inventory> inventory; //!< where it was asked for; the oracle answers by it
    AffineTransform world_from_grid;            //!< to the file's world
    AffineTransform source_index_from_grid;     //!< to the file's index coordinates
    std::string grid_name;
    std::string grid_class;  //!< "level set", "fog volume" or "unknown"
    std::string stored_type; //!< "float32" or "float16"
    double isovalue;         //!< the one used: 0 for level sets unless given
    InsideIs inside;
    double voxel_size;                      //!< shortest side, world units
    std::array<std::size_t, 3> active_size; //!< extent of the active bounding box, voxels
    double min;                             //!< over the active voxels
    double max;
    std::vector<std::string> warnings;
};

//! What the regions of the oracle of a grid are.
enum class VdbRegions
{
    kSides, //!< +1 and -1
    kListed //!< those of an inventory, which takes a pass over the grid's whole box; not where that holds
            //!< over 4e9 voxels, which is warned of
};

//! How to read a .vdb file when the file alone does not settle it.
struct VdbOptions
{
    std::optional<std::string> grid =
        std::nullopt; //!< name; may be left out where the file holds one float grid
    std::optional<double> isovalue =
        std::nullopt; //!< default: 0 for level sets, half of the maximum for fog volumes
    std::optional<InsideIs> inside = std::nullopt; //!< default: below for level sets, above otherwise
    VdbRegions regions = VdbRegions::kSides;
    std::size_t threads = 0; //!< for the inventory; 0 for all there are
};

//! The exact trilinear isosurface of a float grid of a .vdb file, on its sparse tree (nothing is made dense).
//! \throw InputError with the path and the reason: missing, not a VDB file, no or several float grids (lists
//! them), a frustum or sheared transform.
VdbSurface read_vdb_surface(const std::filesystem::path& path, const VdbOptions& options = {});

} // namespace voroprobe
