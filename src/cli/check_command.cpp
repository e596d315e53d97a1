#include "cli/check_command.h"

#include <iostream>

#include "cli/check_run.h"
#include "cli/distinct_files.h"
#include "cli/mesh_defaults.h"
#include "cli/shape_input.h"
#include "cli/summary.h"
#include "cli/warnings.h"
#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "support/error.h"
#include "support/stopwatch.h"

namespace voroprobe
{

namespace
{

//! Vertices of other people's meshes may lie so far from the surface they stand for, voxels: meshes are
//! smoothed and decimated.
constexpr double kReachInVoxels = 2.0;

void check_arguments(const CheckArguments& arguments)
{
    if (arguments.mesh.empty())
        throw UsageError("MESH is ''; allowed: a file");
    if (arguments.against)
    {
        if (is_shape({.path = *arguments.against, .read = {}}))
            throw UsageError("--against is '" + arguments.against->string() +
                             "', which is no volume; allowed: a volume");
        check_read_options(*arguments.against, arguments.read);
    }
    if (!arguments.json)
        return;
    std::vector<NamedFile> inputs{{"MESH", arguments.mesh}};
    if (arguments.against)
        inputs.push_back({"--against", *arguments.against});
    check_distinct(inputs, {{"--json", *arguments.json}});
    check_writable(*arguments.json);
}

SurfaceInput read_scan(const CheckArguments& arguments)
{
    SurfaceInput input = load_surface({.path = *arguments.against,
                                       .read = arguments.read,
                                       .isovalue = arguments.isovalue,
                                       .inside = arguments.inside,
                                       .inventory = InventoryOfSurfaces::kWanted});
    print_warnings(input.warnings);
    if (!input.inventory)
        throw UsageError("--against is '" + arguments.against->string() + "' (" + input.format +
                         "); allowed: a volume whose surfaces can be listed");
    return input;
}

CertificateOptions certificate_options(const CheckArguments& arguments, const SurfaceInput& input)
{
    const VoxelScale voxel = voxel_scale(input.placement.source_index_from_grid);
    return {.reach = kReachInVoxels * voxel.mean_side,
            .caps = arguments.border == BorderFaces::kClosed ? BorderCaps::kCounted : BorderCaps::kLeftOut,
            .criteria = arguments.criteria,
            .sampling = {.mesh_samples = arguments.samples, .surface_samples = arguments.samples / 2},
            .test_self_intersections = false};
}

//! The mesh's own facts are known: those that are decided exactly were decided in the coordinates of the
//! file.
Certificate compare(TriangleMesh mesh, const CheckRun& run, const SurfaceInput& input)
{
    transform(mesh, inverse(output_from_grid(run.arguments.frame, input.placement)));
    Certificate certificate =
        certify(mesh, *input.oracle, input.inventory->surfaces(), certificate_options(run.arguments, input));
    certificate.self_intersections = run.check.self_intersections.size();
    return certificate;
}

} // namespace

void run_check_command(const CheckArguments& arguments)
{
    check_arguments(arguments);
    CheckRun run{.arguments = arguments, .check = {}};
    const Stopwatch reading;
    const std::vector<MeshPart> parts = read_parts(arguments.mesh);
    TriangleMesh mesh = merged(parts);
    std::optional<SurfaceInput> input;
    if (arguments.against)
        input = read_scan(arguments);
    run.seconds_reading = reading.seconds();

    const Stopwatch checking;
    run.check = check_objects(parts, arguments.criteria.min_angle_deg);
    for (const MeshPart& part : parts)
        run.objects.push_back(part.name);
    if (arguments.printable)
    {
        run.print = check_printable(parts, arguments.print);
        print_warnings(run.print->warnings);
    }
    if (input)
    {
        Certificate certificate = compare(std::move(mesh), run, *input);
        run.scan = ScanComparison{std::move(*input), std::move(certificate)};
    }
    run.seconds_checking = checking.seconds();

    if (arguments.json)
        write_text(*arguments.json, check_json(run));
    if (!arguments.quiet)
        std::cout << check_report(run);
    if (const auto wrong = what_is_wrong(run))
        throw Error(ExitStatus::kIncomplete, arguments.mesh.string() + " has " + *wrong);
}

} // namespace voroprobe
