#include "cli/labels_command.h"

#include <iostream>
#include <map>
#include <set>
#include <thread>

#include "cli/label_map_input.h"
#include "cli/labels_report.h"
#include "cli/labels_run.h"
#include "cli/mesh_defaults.h"
#include "cli/output_pattern.h"
#include "cli/summary.h"
#include "cli/warnings.h"
#include "io/mesh_writer.h"
#include "support/error.h"
#include "support/number_text.h"
#include "support/stopwatch.h"

namespace voroprobe
{
namespace
{

namespace fs = std::filesystem;

constexpr double kDefaultSigmaInMeanSides = 1.0;

//! What can be told of the output before anything is read.
MeshFormat check_pattern(const MeshArguments& arguments)
{
    if (arguments.output.empty())
        throw UsageError("--output is required (see voroprobe mesh --help)");
    const MeshFormat format = mesh_format(arguments.output, arguments.format);
    if (arguments.summary)
        check_writable(*arguments.summary);
    return format;
}

void name_outputs(const MeshArguments& arguments, std::vector<LabelOutcome>& labels)
{
    if (!is_output_pattern(arguments.output) && labels.size() > 1)
        throw UsageError("--output is '" + arguments.output.string() + "' for " + count_text(labels.size()) +
                         " labels; allowed: a pattern with {name} or {label}, such as out/{name}.stl");
    std::vector<PatternValues> values;
    values.reserve(labels.size());
    for (const LabelOutcome& label : labels)
        values.push_back({std::to_string(label.value), label.name});
    const std::vector<fs::path> paths = expand_pattern(arguments.output, values);
    for (std::size_t i = 0; i < labels.size(); ++i)
        labels[i].path = paths[i];
}

//! Makes folders that are not there, and tries whether the outputs can be written to them.
void prepare_outputs(const std::vector<LabelOutcome>& labels)
{
    std::set<fs::path> folders;
    for (const LabelOutcome& label : labels)
    {
        const fs::path folder = label.path.parent_path();
        if (!folders.insert(folder).second)
            continue;
        std::error_code error;
        if (!folder.empty() && !fs::exists(folder))
            fs::create_directories(folder, error);
        if (error)
            throw OutputError("cannot make the folder '" + folder.string() + "': " + error.message());
        check_writable(label.path);
    }
}

LabelMeshingOptions options_of(const MeshArguments& arguments, const LabelMap& map)
{
    const VoxelScale voxel = voxel_scale(map.placement.source_index_from_grid);
    LabelMeshingOptions options{.criteria = meshing_options(arguments.criteria, voxel),
                                .smoothing = arguments.label_map.smoothing.value_or(
                                    LabelSmoothing{.method = SmoothingMethod::kGaussian})};
    options.criteria.isolated_vertices = arguments.isolated_vertices;
    if (options.smoothing.sigma == 0.0)
        options.smoothing.sigma = kDefaultSigmaInMeanSides * voxel.mean_side;
    return options;
}

std::vector<std::string> comments_for(const LabelsRun& run, const LabelOutcome& label)
{
    return {std::string("voroprobe ") + VOROPROBE_VERSION,
            "unit: " + std::string(frame_unit(run.arguments.frame)),
            "frame: " + std::string(frame_name(run.arguments.frame)), "label: " + std::to_string(label.value),
            "name: " + label.name};
}

//! Meshes all labels and writes each when it is done.
void mesh_and_write(LabelsRun& run, MeshFormat format, ProgressSink& progress)
{
    const Stopwatch clock;
    std::vector<std::uint32_t> places;
    std::map<std::uint32_t, LabelOutcome*> outcome_at;
    for (LabelOutcome& label : run.labels)
    {
        places.push_back(label.mesh.label);
        outcome_at.emplace(label.mesh.label, &label);
    }
    const AffineTransform to_output = output_from_grid(run.arguments.frame, run.map.placement);
    mesh_labels(run.map.survey, places, run.map.spacing, run.options, run.threads, &progress,
                [&](LabelMesh mesh)
                {
                    LabelOutcome& label = *outcome_at.at(mesh.label);
                    label.vertices = mesh.mesh.vertices.size();
                    label.faces = mesh.mesh.faces.size();
                    transform(mesh.mesh, to_output);
                    write_mesh(mesh.mesh, label.path, format, comments_for(run, label));
                    mesh.mesh = {};
                    label.mesh = std::move(mesh);
                    label.done = true;
                });
    run.timings.refinement = clock.seconds();
}

} // namespace

void run_labels_command(const MeshArguments& arguments)
{
    const Stopwatch clock;
    check_label_arguments(arguments);
    const MeshFormat format = check_pattern(arguments);
    auto progress =
        make_progress(arguments.quiet && arguments.progress == ProgressMode::kAuto ? ProgressMode::kNone
                                                                                   : arguments.progress);
    progress->report({.phase = "read"});
    LabelMap map = read_label_map(arguments);
    std::vector<LabelOutcome> labels = chosen_labels(arguments, map);
    name_outputs(arguments, labels);
    prepare_outputs(labels);
    print_warnings(map.warnings);
    const LabelMeshingOptions options = options_of(arguments, map);
    LabelsRun run{.arguments = arguments,
                  .map = std::move(map),
                  .options = options,
                  .threads = arguments.threads.value_or(std::max(1U, std::thread::hardware_concurrency())),
                  .labels = std::move(labels),
                  .timings = {}};
    run.timings.read = clock.seconds();
    mesh_and_write(run, format, *progress);
    run.timings.total = clock.seconds();
    progress.reset(); // wipes the bar
    if (arguments.summary)
        write_text(*arguments.summary, labels_summary_json(run));
    if (!arguments.quiet)
        std::cout << labels_report(run);
    check_promises(run);
}

} // namespace voroprobe
