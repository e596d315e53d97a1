#include "cli/surface_input.h"

#include "cli/label_map.h"
#include "cli/number_text.h"
#include "cli/shape_input.h"
#include "cli/warnings.h"
#include "oracles/vdb_oracle.h"
#include "support/error.h"
#include "support/text.h"

namespace voroprobe
{

namespace
{

//! Scans show their object inside, so most of their border is outside.
constexpr double kSuspiciousBorderShare = 0.5;

std::string mistaken_sides_warning(double share, InsideIs inside)
{
    const std::string other = inside == InsideIs::kAbove ? "below" : "above";
    return percent_text(share) +
           " of the samples on the border of the volume are inside the object; if it is what lies " + other +
           " the isovalue, give --inside " + other;
}

//! Between a label of 20 and a background of 0 the interpolant passes 0.5 a fortieth of a voxel from the
//! background: every background voxel within ragged parts becomes a speck of its own. Between 1 and 0 it
//! passes halfway.
constexpr const char* kInterpolatedLabelsWarning =
    "this looks like a label map, and labels are interpolated like measurements: a mask (1 where there is "
    "any label, else 0) at --isovalue 0.5 gives a smoother surface with far fewer specks";

//! Where there is no isovalue, the warnings are printed first: they may tell why.
IsovalueChoice choose_or_warn(const SurfaceRequest& request, InsideIs inside, const Volume& volume,
                              const VolumeStatistics& statistics, const std::vector<std::string>& warnings)
{
    try
    {
        return choose_isovalue(request.isovalue, inside, volume, statistics);
    }
    catch (const EmptySurfaceError&)
    {
        print_warnings(warnings);
        throw;
    }
}

SurfaceInput load_volume_surface(const SurfaceRequest& request)
{
    ReadVolume read = read_volume(request.path, request.read);
    const auto volume = std::make_shared<const Volume>(std::move(read.volume));
    const VolumeStatistics statistics = compute_statistics(*volume);
    const InsideIs inside = request.inside.value_or(InsideIs::kAbove);

    std::vector<std::string> warnings = std::move(read.warnings);
    for (std::string& warning : non_finite_warnings(statistics))
        warnings.push_back(std::move(warning));
    const IsovalueChoice isovalue = choose_or_warn(request, inside, *volume, statistics, warnings);

    const GridPlacement placement{volume->geometry.world_from_grid, volume->geometry.source_index_from_grid};
    SurfaceInput input{.oracle = nullptr,
                       .volume = volume,
                       .inventory = nullptr,
                       .placement = placement,
                       .lattice = file_lattice(volume->geometry.size, placement),
                       .format = std::move(read.format),
                       .stored_type = std::move(read.stored_type),
                       .min = statistics.min,
                       .max = statistics.max,
                       .isovalue = isovalue,
                       .inside = inside,
                       .warnings = std::move(warnings)};
    if (request.isovalue && looks_like_label_map(*volume, statistics))
        input.warnings.emplace_back(kInterpolatedLabelsWarning);
    const double border_share = border_share_inside(*volume, input.isovalue.value, inside);
    if (border_share > kSuspiciousBorderShare)
        input.warnings.push_back(mistaken_sides_warning(border_share, inside));
    const LevelledVolume levelled = level_volume(volume, input.isovalue.value, inside);
    if (request.inventory == InventoryOfSurfaces::kWanted)
        input.inventory = std::make_shared<const Inventory>(*make_height_field(levelled));
    input.oracle = make_trilinear_oracle(levelled, input.inventory);
    return input;
}

void check_vdb_isovalue(const VdbSurface& surface)
{
    if (separates(surface.isovalue, surface.inside, surface.min, surface.max))
        return;
    const double working = surface.inside == InsideIs::kBelow && surface.min < 0.0 && surface.max > 0.0
                               ? 0.0
                               : 0.5 * (surface.min + surface.max);
    throw EmptySurfaceError("no surface at isovalue " + number_text(surface.isovalue) +
                            ": the active voxels range from " + number_text(surface.min) + " to " +
                            number_text(surface.max) +
                            (surface.min < surface.max ? "; try --isovalue " + number_text(working) : ""));
}

SurfaceInput load_vdb_surface(const SurfaceRequest& request)
{
    VdbSurface surface = read_vdb_surface(
        request.path, {.grid = request.read.grid,
                       .isovalue = request.isovalue,
                       .inside = request.inside,
                       .regions = request.inventory == InventoryOfSurfaces::kWanted ? VdbRegions::kListed
                                                                                    : VdbRegions::kSides});
    check_vdb_isovalue(surface);
    const GridPlacement placement{surface.world_from_grid, surface.source_index_from_grid};
    return {.oracle = std::move(surface.oracle),
            .inventory = std::move(surface.inventory),
            .placement = placement,
            .lattice = file_lattice(surface.active_size, placement),
            .format = "OpenVDB " + surface.grid_class,
            .stored_type = std::move(surface.stored_type),
            .min = surface.min,
            .max = surface.max,
            .isovalue = {surface.isovalue, request.isovalue ? "given" : "usual for a " + surface.grid_class},
            .inside = surface.inside,
            .warnings = std::move(surface.warnings)};
}

} // namespace

bool is_vdb_path(const std::filesystem::path& path)
{
    return lower_case(path.extension().string()) == ".vdb";
}

void check_read_options(const std::filesystem::path& path, const ReadOptions& options)
{
    if (path.empty())
        throw UsageError("INPUT is '' or missing; required: a file or a folder");
    if (options.series && std::filesystem::is_regular_file(path))
        throw UsageError("--series is '" + *options.series +
                         "'; allowed: only with a folder of DICOM files, " + path.string() + " is a file");
    if (is_vdb_path(path))
    {
        if (options.spacing || options.frame || options.series)
            throw UsageError(
                "--spacing, --frame and --series do not go with a .vdb file: its grids carry their own "
                "transform; choose one with --grid");
    }
    else if (options.grid)
        throw UsageError("--grid is '" + *options.grid + "'; allowed: only with a .vdb file, " +
                         path.string() + " is none");
}

std::vector<std::string> non_finite_warnings(const VolumeStatistics& statistics)
{
    if (statistics.nan_count + statistics.infinite_count == 0)
        return {};
    return {count_text(statistics.nan_count) + " NaN and " + count_text(statistics.infinite_count) +
            " infinite samples count as outside the object"};
}

void check_request(const SurfaceRequest& request)
{
    if (is_shape(request))
        check_shape_request(request);
    else
        check_read_options(request.path, request.read);
}

SurfaceInput load_surface(const SurfaceRequest& request)
{
    check_request(request);
    if (is_shape(request))
        return load_shape(request);
    return is_vdb_path(request.path) ? load_vdb_surface(request) : load_volume_surface(request);
}

} // namespace voroprobe
