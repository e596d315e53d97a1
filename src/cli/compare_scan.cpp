#include "cli/compare_scan.h"

#include <algorithm>

#include "cli/compare_run.h"
#include "cli/mesh_defaults.h"
#include "cli/status_line.h"
#include "cli/surface_input.h"
#include "cli/warnings.h"
#include "io/mesh_reader.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

SurfaceInput load(const CompareArguments& arguments, const std::filesystem::path& path)
{
    SurfaceInput input = load_surface({.path = path,
                                       .read = arguments.read,
                                       .isovalue = arguments.isovalue,
                                       .inside = arguments.inside,
                                       .inventory = InventoryOfSurfaces::kWanted});
    print_warnings(input.warnings);
    if (!input.volume || !input.inventory)
        throw UsageError("INPUT is '" + path.string() + "' (" + input.format +
                         "); allowed: a dense volume, which marching cubes can be run on");
    return input;
}

MeshingTask task_of(const CompareArguments& arguments, const SurfaceInput& input)
{
    const MeshingOptions options =
        meshing_options(arguments.criteria, voxel_scale(input.placement.source_index_from_grid));
    return {.volume = input.volume,
            .isovalue = input.isovalue.value,
            .inside = input.inside,
            .min_facet_angle_deg = options.min_facet_angle_deg,
            .max_facet_radius = options.max_facet_radius,
            .max_facet_distance = *options.max_facet_distance,
            .floor_radius = options.floor_radius,
            .reach = options.reach_lower_bound};
}

std::vector<ContestantEntry> entries_of(const CompareArguments& arguments, const SurfaceInput& input)
{
    std::vector<ContestantEntry> entries;
    for (ContestantEntry& entry : all_contestants())
        if (takes_part(arguments, entry.name))
            entries.push_back(std::move(entry));
    for (const BroughtMesh& brought : arguments.with)
    {
        TriangleMesh mesh = read_mesh(brought.path);
        transform(mesh, inverse(output_from_grid(arguments.frame, input.placement)));
        entries.push_back({brought.name, brought.name, "The mesh " + brought.path.string() + ".", Knob::kNone,
                           [mesh = std::move(mesh)](const MeshingTask&) { return make_given(mesh); }});
    }
    return entries;
}

ScanFacts facts_of(const CompareArguments& arguments, const std::filesystem::path& path,
                   const SurfaceInput& input)
{
    ScanFacts facts = run_facts(arguments, path);
    facts.format = input.format;
    facts.stored_type = input.stored_type;
    facts.size = input.lattice.size;
    facts.spacing = input.lattice.spacing;
    facts.min = input.min;
    facts.max = input.max;
    facts.isovalue_source = input.isovalue.source;
    facts.warnings = input.warnings;
    return facts;
}

} // namespace

ScanReport compare_scan(const CompareArguments& arguments, const std::filesystem::path& path,
                        const std::string& stem, const std::optional<std::string>& no_pictures)
{
    const StatusLine status(!arguments.quiet);
    status.tell(path.string() + ": reading");
    const SurfaceInput input = load(arguments, path);
    const VoxelScale voxel = voxel_scale(input.placement.source_index_from_grid);
    const ReferenceSurface reference{.oracle = input.oracle,
                                     .inventory = input.inventory,
                                     .world_from_grid = input.placement.world_from_grid,
                                     .voxel = voxel.mean_side};
    const MeshingTask task = task_of(arguments, input);
    const CompetitionOptions options =
        competition_options(arguments, task.min_facet_angle_deg, no_pictures.has_value(),
                            [&](const std::string& done) { status.tell(path.string() + ": " + done); });
    ScanFacts facts = facts_of(arguments, path, input);
    facts.stem = stem;
    facts.no_pictures = no_pictures;
    return make_scan_report(facts, entries_of(arguments, input), task, reference, options);
}

} // namespace voroprobe
