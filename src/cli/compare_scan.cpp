#include "cli/compare_scan.h"

#include <algorithm>
#include <ctime>
#include <iostream>
#include <thread>

#include <unistd.h>

#include "cli/interrupt.h"
#include "cli/mesh_defaults.h"
#include "cli/number_text.h"
#include "cli/surface_input.h"
#include "cli/warnings.h"
#include "io/mesh_reader.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

//! A line on the terminal that the next one takes the place of.
class StatusLine
{
public:
    explicit StatusLine(bool shown) : shown_(shown && isatty(STDERR_FILENO) == 1)
    {
        if (shown_)
            set_bar_shown(true);
    }
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;
    ~StatusLine()
    {
        if (!shown_)
            return;
        std::cerr << kWipeLine << std::flush;
        set_bar_shown(false);
    }

    void tell(const std::string& text) const
    {
        if (shown_)
            std::cerr << kWipeLine << text << std::flush;
    }

private:
    bool shown_;
};

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
        if (!arguments.contestants || std::find(arguments.contestants->begin(), arguments.contestants->end(),
                                                entry.name) != arguments.contestants->end())
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

std::string today()
{
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d", &utc);
    return text;
}

//! What the shell would have to be given; words with anything else than the usual are quoted.
std::string command_text(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
    {
        const bool plain =
            !word.empty() &&
            word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                   "_-./=,:+@%") == std::string::npos;
        std::string quoted = "'";
        for (const char c : word)
            quoted += c == '\'' ? "'\\''" : std::string(1, c);
        text += (text.empty() ? "" : " ") + (plain ? word : quoted + "'");
    }
    return text;
}

ScanFacts facts_of(const CompareArguments& arguments, const std::filesystem::path& path,
                   const SurfaceInput& input)
{
    const std::filesystem::path name =
        path.filename().empty() ? path.parent_path().filename() : path.filename();
    return {.name = name.string(),
            .path = path.string(),
            .format = input.format,
            .stored_type = input.stored_type,
            .size = input.lattice.size,
            .spacing = input.lattice.spacing,
            .min = input.min,
            .max = input.max,
            .isovalue_source = input.isovalue.source,
            .warnings = input.warnings,
            .version = VOROPROBE_VERSION,
            .command = command_text(arguments.command),
            .date = today(),
            .stem = {}};
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
    const CompetitionOptions options{
        .measuring = {.mesh_samples = arguments.samples, .angle_bound_deg = task.min_facet_angle_deg},
        .contestant_seconds = arguments.contestant_seconds,
        .sweep_seconds = arguments.sweep_seconds,
        .at_once = arguments.at_once.value_or(std::max(1U, std::thread::hardware_concurrency())),
        .pictures = arguments.pictures && !no_pictures,
        .tell = [&](const std::string& done) { status.tell(path.string() + ": " + done); }};
    ScanFacts facts = facts_of(arguments, path, input);
    facts.stem = stem;
    facts.no_pictures = no_pictures;
    return make_scan_report(facts, entries_of(arguments, input), task, reference, options);
}

} // namespace voroprobe
