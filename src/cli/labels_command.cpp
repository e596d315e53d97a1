#include "cli/labels_command.h"

#include <iostream>
#include <map>
#include <thread>

#include "cli/distinct_files.h"
#include "cli/label_map_input.h"
#include "cli/label_output.h"
#include "cli/labels_report.h"
#include "cli/labels_run.h"
#include "cli/mesh_budget.h"
#include "cli/output_pattern.h"
#include "cli/summary.h"
#include "cli/warnings.h"
#include "io/mesh_writer.h"
#include "labels/joint_meshing.h"
#include "support/error.h"
#include "support/number_text.h"
#include "support/stopwatch.h"

namespace voroprobe
{
namespace
{

//! `meshes`: what is written beside the summary.
void check_files(const MeshArguments& arguments, std::vector<NamedFile> meshes)
{
    std::vector<NamedFile> inputs{{"INPUT", arguments.input}};
    if (arguments.label_map.names)
        inputs.push_back({"--names", *arguments.label_map.names});
    if (arguments.summary)
        meshes.push_back({"--summary", *arguments.summary});
    check_distinct(inputs, meshes);
}

//! What a pattern stands for, once the labels are known.
void check_expanded(const LabelsRun& run)
{
    if (!is_output_pattern(run.arguments.output))
        return; // was looked at
    std::vector<NamedFile> meshes;
    for (const LabelOutcome& label : run.labels)
        meshes.push_back({"OUTPUT for label " + std::to_string(label.value), label.path});
    check_files(run.arguments, std::move(meshes));
}

//! What can be told of the output before anything is read.
MeshFormat check_pattern(const MeshArguments& arguments)
{
    if (arguments.output.empty())
        throw UsageError("--output is required (see voroprobe mesh --help)");
    const MeshFormat format = mesh_format(arguments.output, arguments.format);
    check_files(arguments, {{"OUTPUT", arguments.output}});
    if (arguments.summary)
        check_writable(*arguments.summary);
    return format;
}

//! \throw UsageError where labels that overlap are to share their interfaces.
void check_layers(const MeshArguments& arguments, const LabelMap& map)
{
    const bool jointly =
        arguments.label_map.shared_interfaces ||
        (arguments.label_map.smoothing && arguments.label_map.smoothing->method == SmoothingMethod::kJoint);
    if (jointly && map.layers.size() > 1)
        throw UsageError("--shared-interfaces is given, but the segments lie in " +
                         count_text(map.layers.size()) +
                         " layers and may overlap; allowed: one layer, chosen with --frame 0 to " +
                         std::to_string(map.layers.size() - 1));
}

//! The labels asked for that are in a layer, by their places.
std::vector<std::uint32_t> places_in_layer(const LabelsRun& run, std::size_t layer)
{
    std::vector<std::uint32_t> places;
    for (const LabelOutcome& label : run.labels)
        if (label.layer == layer)
            places.push_back(label.mesh.label);
    return places;
}

//! \throw UsageError where a label would take more vertices than memory holds.
void check_sizes(const LabelsRun& run)
{
    const Vec3& side = run.map.spacing;
    for (std::size_t layer = 0; layer < run.map.layers.size(); ++layer)
        check_size(run.options.criteria, run.map.layers[layer], places_in_layer(run, layer),
                   side.x * side.y * side.z, run.threads);
}

//! Meshes all labels, layer by layer, and hands each over to the output when it is done.
void mesh_and_write(LabelsRun& run, LabelOutput& output, ProgressSink& progress)
{
    const Stopwatch clock;
    const AffineTransform to_output = output_from_grid(run.arguments.frame, run.map.placement);
    for (std::size_t layer = 0; layer < run.map.layers.size(); ++layer)
    {
        const std::vector<std::uint32_t> places = places_in_layer(run, layer);
        std::map<std::uint32_t, LabelOutcome*> outcome_at;
        for (LabelOutcome& label : run.labels)
            if (label.layer == layer)
                outcome_at.emplace(label.mesh.label, &label);
        const auto take = [&](LabelMesh mesh)
        {
            LabelOutcome& label = *outcome_at.at(mesh.label);
            label.vertices = mesh.mesh.vertices.size();
            label.faces = mesh.mesh.faces.size();
            transform(mesh.mesh, to_output);
            output.take(label, std::move(mesh.mesh));
            label.mesh = std::move(mesh);
            label.done = true;
        };
        const LabelSurvey& survey = run.map.layers[layer];
        if (run.options.smoothing.method == SmoothingMethod::kJoint)
            mesh_labels_jointly(survey, places, run.map.spacing, run.options.criteria, &progress, take);
        else
            mesh_labels(survey, places, run.map.spacing, run.options, run.threads, &progress, take);
    }
    output.finish();
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
    check_layers(arguments, map);
    print_warnings(map.warnings);
    const std::size_t threads = arguments.threads.value_or(std::max(1U, std::thread::hardware_concurrency()));
    const LabelMeshingOptions options = label_meshing_options(arguments, map, threads);
    LabelsRun run{.arguments = arguments,
                  .map = std::move(map),
                  .options = options,
                  .threads = threads,
                  .labels = std::move(labels),
                  .timings = {}};
    check_sizes(run);
    LabelOutput output(arguments, format, run.labels);
    check_expanded(run);
    output.prepare();
    run.timings.read = clock.seconds();
    mesh_and_write(run, output, *progress);
    run.timings.total = clock.seconds();
    progress.reset(); // wipes the bar
    if (arguments.summary)
        write_text(*arguments.summary, labels_summary_json(run));
    if (!arguments.quiet)
        std::cout << labels_report(run);
    check_promises(run);
}

} // namespace voroprobe
