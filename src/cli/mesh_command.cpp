#include "cli/mesh_command.h"

#include <iostream>

#include "cli/interrupt.h"
#include "cli/mesh_report.h"
#include "cli/mesh_run.h"
#include "cli/number_text.h"
#include "cli/summary.h"
#include "cli/warnings.h"
#include "io/mesh_writer.h"
#include "support/error.h"
#include "support/stopwatch.h"

namespace voroprobe
{

namespace
{

namespace fs = std::filesystem;

void check_distinct(const fs::path& a, const char* name_of_a, const fs::path& b, const char* name_of_b)
{
    std::error_code unknown; // what does not exist is not the same
    if (fs::weakly_canonical(a, unknown) == fs::weakly_canonical(b, unknown))
        throw UsageError(std::string(name_of_a) + " and " + name_of_b + " are both " + a.string() +
                         "; allowed: two files");
}

//! Everything that can be refused before the input is read.
MeshFormat check_outputs(const MeshArguments& arguments)
{
    const MeshFormat format = mesh_format(arguments.output, arguments.format);
    check_distinct(arguments.output, "OUTPUT", arguments.input, "INPUT");
    check_writable(arguments.output);
    if (arguments.summary)
    {
        check_distinct(*arguments.summary, "--summary", arguments.input, "INPUT");
        check_distinct(*arguments.summary, "--summary", arguments.output, "OUTPUT");
        check_writable(*arguments.summary);
    }
    return format;
}

MeshingOptions options_of(const MeshArguments& arguments, const SurfaceInput& input)
{
    MeshingOptions options =
        meshing_options(arguments.criteria, voxel_scale(input.placement.source_index_from_grid));
    options.isolated_vertices = arguments.isolated_vertices;
    options.close_border = arguments.border == BorderFaces::kClosed;
    options.max_vertices = arguments.max_vertices;
    return options;
}

MeshRun read_input(const MeshArguments& arguments, ProgressSink& progress)
{
    const Stopwatch clock;
    progress.report({.phase = "read"});
    MeshRun run{.arguments = arguments,
                .input = load_surface({.path = arguments.input,
                                       .read = arguments.read,
                                       .isovalue = arguments.isovalue,
                                       .inside = arguments.inside}),
                .options = {},
                .statistics = {},
                .facts = {},
                .output_box = {},
                .timings = {}};
    run.options = options_of(arguments, run.input);
    run.timings.read = clock.seconds();
    return run;
}

//! \throw Error where there is nothing to write.
TriangleMesh refine_surface(MeshRun& run, ProgressSink& progress)
{
    const Stopwatch clock;
    MeshingResult result = mesh_surface(*run.input.oracle, run.options, &progress);
    run.timings.refinement = clock.seconds();
    run.statistics = result.statistics;
    if (result.status == MeshingStatus::kBudgetExhausted)
        run.status = RunStatus::kPartial;
    if (!result.mesh.faces.empty())
        return std::move(result.mesh);
    if (run.status == RunStatus::kPartial)
        throw Error(ExitStatus::kBudget, "--max-vertices " +
                                             std::to_string(run.options.max_vertices.value_or(0)) +
                                             " was reached before there was a face; nothing was written");
    throw EmptySurfaceError("no face at isovalue " + number_text(run.input.isovalue.value) +
                            ": the samples range from " + number_text(run.input.min) + " to " +
                            number_text(run.input.max) +
                            ", but no probe met the surface or all of it is smaller than --floor " +
                            number_text(run.options.floor_radius) + " mm; nothing was written");
}

std::vector<std::string> comments_for(const MeshRun& run)
{
    return {std::string("voroprobe ") + VOROPROBE_VERSION,
            "unit: " + std::string(frame_unit(run.arguments.frame)),
            "frame: " + std::string(frame_name(run.arguments.frame)),
            "isovalue: " + number_text(run.input.isovalue.value)};
}

//! From here on a signal comes too late. To be called before the output takes its place.
void pass_point_of_no_return()
{
    set_on_interrupt(OnInterrupt::kFinish);
    if (interrupt_requested())
        throw Error(ExitStatus::kInterrupted, "interrupted; nothing was written");
}

void check_and_write(TriangleMesh& mesh, MeshFormat format, MeshRun& run, ProgressSink& progress)
{
    const Stopwatch clock;
    progress.report({.phase = "write", .vertices = mesh.vertices.size()});
    run.facts = measure_mesh(mesh, run.options.min_facet_angle_deg);
    if (run.status == RunStatus::kDone && broken_promise(run.facts, run.arguments.border))
        run.status = RunStatus::kIncomplete;
    transform(mesh, output_from_grid(run.arguments.frame, run.input.placement));
    run.output_box = bounding_box(mesh);
    write_mesh(mesh, run.arguments.output, format, comments_for(run), pass_point_of_no_return);
    run.timings.write = clock.seconds();
}

std::vector<std::string> result_warnings(const MeshRun& run)
{
    std::vector<std::string> warnings;
    if (const std::size_t abandoned = run.statistics.isolated_vertices_abandoned; abandoned > 0)
        warnings.push_back(
            count_text(abandoned) +
            " points of the surface are on no face of the mesh: parts about as small as --floor " +
            number_text(run.options.floor_radius) + " mm may be missing");
    if (const std::size_t carved = run.statistics.contacts_carved; carved > 0)
        warnings.push_back(
            "the surface touched itself at " + count_text(carved) +
            " vertices where it could not be drawn apart: the object was cut away around them");
    return warnings;
}

} // namespace

void run_mesh_command(const MeshArguments& arguments)
{
    const Stopwatch clock;
    const MeshFormat format = check_outputs(arguments);
    check_read_options(arguments.input, arguments.read);
    auto progress =
        make_progress(arguments.quiet && arguments.progress == ProgressMode::kAuto ? ProgressMode::kNone
                                                                                   : arguments.progress);
    MeshRun run = read_input(arguments, *progress);
    print_warnings(run.input.warnings);
    TriangleMesh mesh = refine_surface(run, *progress);
    check_and_write(mesh, format, run, *progress);
    run.timings.total = clock.seconds();
    progress.reset(); // wipes the bar
    print_warnings(result_warnings(run));
    if (arguments.summary)
        write_text(*arguments.summary, summary_json(run));
    if (!arguments.quiet)
        std::cout << mesh_report(run);
    check_promises(run);
}

} // namespace voroprobe
