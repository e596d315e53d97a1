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
#include "oracles/implicit_domain.h"
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

//! A level set of a formula.
struct FormulaRequest
{
    std::string text;
    std::string domain; //!< as parse_domain() takes it
};

//! Which surface of which file.
struct SurfaceRequest
{
    std::filesystem::path path; //!< empty for a formula
    ReadOptions read;
    std::optional<double> isovalue = std::nullopt; //!< unset: automatic
    std::optional<InsideIs> inside =
        std::nullopt; //!< unset: below for level sets in .vdb files and formulas, above otherwise
    std::optional<FormulaRequest> formula = std::nullopt; //!< in place of a file
    InventoryOfSurfaces inventory = InventoryOfSurfaces::kNotWanted;
};

//! What a surface comes from.
enum class InputKind
{
    kVolume, //!< dense or sparse
    kFormula,
    kTriangleMesh,
    kPointCloud
};

//! A surface ready to be meshed and what there is to say of the file it came from, dense volume or sparse
//! grid alike. What speaks of samples says nothing where the input is no volume.
struct SurfaceInput
{
    InputKind kind = InputKind::kVolume;
    std::shared_ptr<const SurfaceOracle> oracle;          //!< frame: grid
    std::shared_ptr<const Volume> volume = nullptr;       //!< where the input is a dense one
    std::shared_ptr<const Inventory> inventory = nullptr; //!< where it was wanted; the oracle knows it
    GridPlacement placement;
    FileLattice lattice;
    std::string format;           //!< "NRRD", "OpenVDB level set", ...
    std::string description = {}; //!< of an input that is no volume, for people
    std::string stored_type;      //!< sample type in the file
    double min;                   //!< over the finite samples (.vdb: over the active voxels)
    double max;
    IsovalueChoice isovalue;
    InsideIs inside;
    std::optional<ImplicitDomain> domain = std::nullopt; //!< of a formula
    std::vector<std::string> warnings;                   //!< one line each, for the user

    [[nodiscard]] bool has_isovalue() const
    {
        return kind == InputKind::kVolume || kind == InputKind::kFormula;
    }
};

//! Whether a path is read as an OpenVDB grid.
bool is_vdb_path(const std::filesystem::path& path);

//! \throw UsageError where an option does not go with the kind of file; InputError as the readers;
//! EmptySurfaceError and UsageError as choose_isovalue.
void check_read_options(const std::filesystem::path& path, const ReadOptions& options);

//! Warnings about samples that are not numbers; none where all are.
std::vector<std::string> non_finite_warnings(const VolumeStatistics& statistics);

//! \throw UsageError and others as check_read_options: what can be told of a request before anything is read.
void check_request(const SurfaceRequest& request);

//! Reads the file, settles the isovalue and makes the oracle. \throw as check_request, the readers, the
//! oracles and choose_isovalue.
SurfaceInput load_surface(const SurfaceRequest& request);

} // namespace voroprobe
