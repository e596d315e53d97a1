#include "cli/mesh_command.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "cli/distinct_files.h"
#include "cli/interrupt.h"
#include "cli/label_map_input.h"
#include "cli/labels_command.h"
#include "cli/mesh_budget.h"
#include "cli/mesh_certificate.h"
#include "cli/mesh_report.h"
#include "cli/mesh_run.h"
#include "cli/normals_argument.h"
#include "cli/number_text.h"
#include "cli/shape_input.h"
#include "cli/summary.h"
#include "cli/warnings.h"
#include "io/mesh_writer.h"
#include "support/error.h"
#include "support/stopwatch.h"
#include "support/thread_limit.h"

namespace voroprobe
{

namespace
{

SurfaceRequest request_of(const MeshArguments& arguments)
{
    SurfaceRequest request{.path = arguments.input,
                           .read = arguments.read,
                           .isovalue = arguments.isovalue,
                           .inside = arguments.inside,
                           .inventory = InventoryOfSurfaces::kWanted};
    if (arguments.formula)
        request.formula = FormulaRequest{*arguments.formula, arguments.domain.value_or("")};
    return request;
}

void check_input(const MeshArguments& arguments)
{
    if (arguments.formula && !arguments.domain)
        throw UsageError(
            "--domain is missing; --implicit requires it: box:x0,y0,z0,x1,y1,z1 or ball:cx,cy,cz,r");
    if (!arguments.formula && arguments.domain)
        throw UsageError("--domain is '" + *arguments.domain + "'; allowed: only with --implicit");
    const SurfaceRequest request = request_of(arguments);
    check_request(request);
    check_theorem(arguments.finding, arguments.criteria);
    if (is_shape(request) && arguments.frame == OutputFrame::kIndex)
        throw UsageError("--frame-of-reference is 'index'; allowed: lps, ras, as there are no voxels");
}

//! Steps on the shape and the place go with closed meshes in mm.
void check_finish(const MeshArguments& arguments)
{
    if (arguments.finish.changes_shape() && arguments.border == BorderFaces::kOpen)
        throw UsageError("--border is 'open'; allowed: closed, with --decimate, --max-error and --relax");
    if (!arguments.finish.placement.keeps_all() && arguments.frame == OutputFrame::kIndex)
        throw UsageError(
            "--frame-of-reference is 'index'; allowed: lps, ras, with --scale, --rotate, --translate, "
            "--center and --on-bed");
}

void check_files(const MeshArguments& arguments)
{
    std::vector<NamedFile> inputs;
    if (!arguments.formula)
        inputs.push_back({"INPUT", arguments.input});
    if (arguments.finding.seeds)
        inputs.push_back({"--seeds", *arguments.finding.seeds});
    std::vector<NamedFile> outputs{{"OUTPUT", arguments.output}};
    if (arguments.summary)
        outputs.push_back({"--summary", *arguments.summary});
    check_distinct(inputs, outputs);
}

//! Everything that can be refused before the input is read.
MeshFormat check_outputs(const MeshArguments& arguments)
{
    if (arguments.output.empty())
        throw UsageError("--output is required (see voroprobe mesh --help)");
    const MeshFormat format = mesh_format(arguments.output, arguments.format);
    normals_argument(arguments.normals, format);
    check_files(arguments);
    if (format == MeshFormat::k3mf && arguments.frame == OutputFrame::kIndex)
        throw UsageError(
            "--frame-of-reference is 'index'; allowed: lps, ras, as 3MF files are in millimetres");
    check_writable(arguments.output);
    if (arguments.summary)
        check_writable(*arguments.summary);
    return format;
}

MeshingOptions options_of(const MeshArguments& arguments, const SurfaceInput& input)
{
    const VoxelScale scale = voxel_scale(input.placement.source_index_from_grid);
    MeshingOptions options = meshing_options(arguments.criteria, scale);
    options.isolated_vertices = arguments.isolated_vertices;
    options.close_border = arguments.border == BorderFaces::kClosed;
    options.max_vertices = arguments.max_vertices.value_or(vertices_in_memory());
    options.threads = arguments.threads.value_or(0);
    options.random_seed = arguments.seed;
    apply_seeding(arguments.finding, input.placement, options);
    if (input.inventory && !arguments.max_vertices && !options.max_seconds)
        check_size(options, *input.inventory, std::pow(scale.mean_side, 3));
    return options;
}

MeshRun read_input(const MeshArguments& arguments, ProgressSink& progress)
{
    const Stopwatch clock;
    progress.report({.phase = "read"});
    MeshRun run{.arguments = arguments,
                .input = load_surface(request_of(arguments)),
                .options = {},
                .statistics = {},
                .facts = {},
                .output_box = {},
                .timings = {}};
    check_selection(arguments, run.input);
    run.options = options_of(arguments, run.input);
    run.timings.read = clock.seconds();
    return run;
}

//! \throw Error where there is nothing to write.
MeshingResult refine_surface(MeshRun& run, ProgressSink& progress)
{
    const Stopwatch clock;
    MeshingResult result = mesh_surface(*run.input.oracle, run.options, &progress);
    run.timings.refinement = clock.seconds();
    run.statistics = result.statistics;
    if (result.status == MeshingStatus::kBudgetExhausted)
        run.status = RunStatus::kPartial;
    if (!result.mesh.faces.empty())
        return result;
    if (run.status == RunStatus::kPartial)
        throw Error(ExitStatus::kBudget,
                    budget_text(run) + " was reached before there was a face; nothing was written");
    if (run.input.kind != InputKind::kVolume)
        throw EmptySurfaceError(run.input.description +
                                ": no probe met a surface, or all of it is smaller than --floor " +
                                number_text(run.options.floor_radius) + " mm; nothing was written");
    throw EmptySurfaceError("no face at isovalue " + number_text(run.input.isovalue.value) +
                            ": the samples range from " + number_text(run.input.min) + " to " +
                            number_text(run.input.max) +
                            ", but no probe met the surface or all of it is smaller than --floor " +
                            number_text(run.options.floor_radius) + " mm; nothing was written");
}

std::vector<std::string> comments_for(const MeshRun& run)
{
    std::vector<std::string> comments{std::string("voroprobe ") + VOROPROBE_VERSION,
                                      "unit: " + std::string(frame_unit(run.arguments.frame)),
                                      "frame: " + std::string(frame_name(run.arguments.frame))};
    if (run.input.has_isovalue())
        comments.push_back("isovalue: " + number_text(run.input.isovalue.value));
    return comments;
}

//! Rounding of a vertex on the border of the domain, as a fraction of the domain's diagonal.
constexpr double kBorderRounding = 1e-9;

//! Vertices where a domain cuts the object.
std::size_t count_on_border(const TriangleMesh& mesh, const ImplicitDomain& domain)
{
    const double rounding = kBorderRounding * domain.bounding_box().diagonal();
    return static_cast<std::size_t>(std::count_if(mesh.vertices.begin(), mesh.vertices.end(),
                                                  [&](const Point3& p)
                                                  { return domain.distance_beyond(p) >= -rounding; }));
}

void check_and_write(TriangleMesh& mesh, MeshFormat format, MeshRun& run, ProgressSink& progress)
{
    const Stopwatch clock;
    progress.report({.phase = "write", .vertices = mesh.vertices.size()});
    run.facts = measure_mesh(mesh, run.options.min_facet_angle_deg,
                             run.certificate ? std::optional(run.certificate->topology) : std::nullopt);
    if (run.status == RunStatus::kDone && broken_promise(run.facts, run.arguments.border))
        run.status = RunStatus::kIncomplete;
    if (run.input.domain)
        run.vertices_on_border = count_on_border(mesh, *run.input.domain);
    transform(mesh, output_from_grid(run.arguments.frame, run.input.placement));
    std::vector<MeshPart> parts{{.name = "", .mesh = std::move(mesh)}};
    place(parts, run.arguments.finish.placement);
    mesh = std::move(parts.front().mesh);
    run.output_box = bounding_box(mesh);
    write_mesh(mesh, run.arguments.output, format, comments_for(run), pass_point_of_no_return,
               normals_argument(run.arguments.normals, format));
    run.timings.write = clock.seconds();
}

std::vector<std::string> result_warnings(const MeshRun& run)
{
    std::vector<std::string> warnings;
    if (const std::size_t off = run.statistics.seeds_off_surface; off > 0)
        warnings.push_back(count_text(off) + " points of --seeds are farther from the surface than --reach " +
                           number_text(run.options.reach_lower_bound) + " mm and were left out");
    const std::size_t found = run.facts.topology.components;
    if (const auto& wanted = run.options.component_count; wanted && found < *wanted)
        warnings.push_back("--components is " + count_text(*wanted) + ", but the mesh has " +
                           count_text(found));
    const std::size_t abandoned = run.statistics.isolated_vertices_abandoned;
    if (abandoned > 0 && !run.certificate) // which knows
        warnings.push_back(
            count_text(abandoned) +
            " points of the surface are on no face of the mesh: parts about as small as --floor " +
            number_text(run.options.floor_radius) + " mm may be missing");
    if (const std::size_t carved = run.statistics.contacts_carved; carved > 0)
        warnings.push_back(
            "the surface touched itself at " + count_text(carved) +
            " vertices where it could not be drawn apart: the object was cut away around them");
    if (const std::size_t count = run.vertices_on_border; count > 0)
        warnings.push_back("the object leaves the domain: " + count_text(count) +
                           " vertices of the mesh lie on the border of --domain, where it was " +
                           (run.options.close_border ? "closed" : "left open"));
    return warnings;
}

} // namespace

void run_mesh_command(const MeshArguments& arguments)
{
    const Stopwatch clock;
    std::optional<ThreadLimit> limit;
    if (arguments.threads)
        limit.emplace(*arguments.threads);
    check_label_arguments(arguments);
    if (arguments.label_map.wanted())
        return run_labels_command(arguments);
    check_input(arguments);
    check_finish(arguments);
    const MeshFormat format = check_outputs(arguments);
    auto progress =
        make_progress(arguments.quiet && arguments.progress == ProgressMode::kAuto ? ProgressMode::kNone
                                                                                   : arguments.progress);
    MeshRun run = read_input(arguments, *progress);
    print_warnings(run.input.warnings);
    MeshingResult result = refine_surface(run, *progress);
    progress->report({.phase = "check", .vertices = result.mesh.vertices.size()});
    const std::vector<DroppedSurface> dropped = drop_unwanted(run, result);
    finish_shape(run, result);
    certify_mesh(run, result, dropped);
    check_and_write(result.mesh, format, run, *progress);
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
