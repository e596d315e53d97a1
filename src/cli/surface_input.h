#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/file_lattice.h"
#include "cli/isovalue_choice.h"
#include "cli/output_frame.h"
#include "io/volume_reader.h"
#include "oracles/surface_oracle.h"
#include "oracles/trilinear_oracle.h"
#include "volume/inventory.h"

namespace voroprobe
{

//! Whether the oracle is to know the surfaces of the scan one by one.
enum class InventoryOfSurfaces
{
    kNotWanted,
    kWanted
};

//! Which surface of which file.
struct SurfaceRequest
{
    std::filesystem::path path;
    ReadOptions read;
    std::optional<double> isovalue = std::nullopt; //!< unset: automatic
    std::optional<InsideIs> inside =
        std::nullopt; //!< unset: below for level sets in .vdb files, above otherwise
    InventoryOfSurfaces inventory = InventoryOfSurfaces::kNotWanted;
};

//! A surface ready to be meshed and what there is to say of the file it came from, dense volume or sparse
//! grid alike.
struct SurfaceInput
{
    std::unique_ptr<SurfaceOracle> oracle;                //!< frame: grid
    std::shared_ptr<const Inventory> inventory = nullptr; //!< where it was wanted; the oracle knows it
    GridPlacement placement;
    FileLattice lattice;
    std::string format;      //!< "NRRD", "OpenVDB level set", ...
    std::string stored_type; //!< sample type in the file
    double min;              //!< over the finite samples (.vdb: over the active voxels)
    double max;
    IsovalueChoice isovalue;
    InsideIs inside;
    std::vector<std::string> warnings; //!< one line each, for the user
};

//! Whether a path is read as an OpenVDB grid.
bool is_vdb_path(const std::filesystem::path& path);

//! \throw UsageError where an option does not go with the kind of file; InputError as the readers;
//! EmptySurfaceError and UsageError as choose_isovalue.
void check_read_options(const std::filesystem::path& path, const ReadOptions& options);

//! Warnings about samples that are not numbers; none where all are.
std::vector<std::string> non_finite_warnings(const VolumeStatistics& statistics);

//! Reads the file, settles the isovalue and makes the oracle. \throw as check_read_options, the readers and
//! choose_isovalue.
SurfaceInput load_surface(const SurfaceRequest& request);

} // namespace voroprobe
