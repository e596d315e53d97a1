#include "cli/compare_labels.h"

#include <memory>
#include <utility>

#include "cli/compare_run.h"
#include "cli/label_map_input.h"
#include "cli/labels_run.h"
#include "cli/mesh_arguments.h"
#include "cli/status_line.h"
#include "cli/warnings.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

//! What `mesh --labels` would be told.
MeshArguments mesh_arguments(const CompareArguments& arguments, const std::filesystem::path& path)
{
    MeshArguments result;
    result.input = path;
    result.read = arguments.read;
    result.isovalue = arguments.isovalue;
    result.inside = arguments.inside;
    result.criteria = arguments.criteria;
    result.label_map = arguments.label_map;
    return result;
}

LabelMap read_one_layer(const MeshArguments& arguments)
{
    LabelMap map = read_label_map(arguments);
    if (map.layers.size() > 1)
        throw UsageError("INPUT is '" + arguments.input.string() + "' with " +
                         std::to_string(map.layers.size()) +
                         " layers of segments; allowed: one layer, chosen by --frame");
    print_warnings(map.warnings);
    return map;
}

LabelTask task_of(const MeshArguments& arguments, LabelMap& map)
{
    LabelTask task{.survey = nullptr,
                   .labels = {},
                   .spacing = map.spacing,
                   .world_from_grid = map.placement.world_from_grid,
                   .voxel = voxel_scale(map.placement.source_index_from_grid).mean_side,
                   .options = label_meshing_options(arguments, map, 1)};
    for (const LabelOutcome& label : chosen_labels(arguments, map))
        task.labels.push_back(label.mesh.label);
    task.survey = std::make_shared<const LabelSurvey>(std::move(map.layers.front()));
    return task;
}

std::vector<LabelContestantEntry> entries_of(const CompareArguments& arguments)
{
    std::vector<LabelContestantEntry> entries = all_label_contestants();
    std::erase_if(entries,
                  [&](const LabelContestantEntry& entry) { return !takes_part(arguments, entry.name); });
    return entries;
}

} // namespace

void check_compared_labels(const CompareArguments& arguments, const std::filesystem::path& path)
{
    const LabelArguments& labels = arguments.label_map;
    check_label_arguments(mesh_arguments(arguments, path));
    if (!labels.wanted())
        return;
    if (labels.smoothing && labels.smoothing->method == SmoothingMethod::kJoint)
        throw UsageError("labels that share interfaces are not compared; allowed: --smooth none, gaussian or "
                         "antialias");
    if (!arguments.with.empty())
        throw UsageError("--with does not go with --labels");
    if (entries_of(arguments).empty())
        throw UsageError("--contestants names none that meshes labels; allowed with --labels: voroprobe, "
                         "marching_cubes, smoothed, decimated");
}

ScanReport compare_labels(const CompareArguments& arguments, const std::filesystem::path& path,
                          const std::string& stem, const std::optional<std::string>& no_pictures)
{
    const StatusLine status(!arguments.quiet);
    status.tell(path.string() + ": reading");
    const MeshArguments as_mesh = mesh_arguments(arguments, path);
    LabelMap map = read_one_layer(as_mesh);
    ScanFacts facts = run_facts(arguments, path);
    facts.format = map.format;
    facts.stored_type = map.stored_type;
    facts.size = map.lattice.size;
    facts.spacing = map.lattice.spacing;
    facts.warnings = map.warnings;
    facts.stem = stem;
    facts.no_pictures = no_pictures;
    const LabelTask task = task_of(as_mesh, map);
    const CompetitionOptions options =
        competition_options(arguments, arguments.criteria.angle_deg, no_pictures.has_value(),
                            [&](const std::string& done) { status.tell(path.string() + ": " + done); });
    return make_label_report(facts, entries_of(arguments), task, options);
}

} // namespace voroprobe
