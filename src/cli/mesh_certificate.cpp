#include "cli/mesh_certificate.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "certificate/mesh_distance.h"
#include "certificate/mesh_samples.h"
#include "certificate/surface_selection.h"
#include "cli/process_steps.h"
#include "cli/surface_dropping.h"
#include "support/error.h"
#include "support/stopwatch.h"

namespace voroprobe
{
namespace
{

//! Vertices of ours lie on the surface; those drawn apart where it touches itself, a hair beside it.
constexpr double kReachInVoxels = 1.0;

double voxel_volume(const SurfaceInput& input)
{
    return 1.0 / std::abs(determinant(input.placement.source_index_from_grid.linear));
}

//! The distance criterion of refinement holds on; where there is none, a share of an edge.
double relaxation_bound(const MeshRun& run, double edge)
{
    constexpr double kShareOfEdge = 0.25;
    return std::min(run.options.max_facet_distance.value_or(kShareOfEdge * edge),
                    run.arguments.finish.max_distance.value_or(edge));
}

} // namespace

void check_selection(const MeshArguments& arguments, const SurfaceInput& input)
{
    if (!arguments.selection.keeps_all() && !input.inventory)
        throw UsageError("--min-component-volume, --keep-largest and --drop-cavities go with volumes only, "
                         "and the input is: " +
                         input.format);
}

std::vector<DroppedSurface> drop_unwanted(MeshRun& run, MeshingResult& result)
{
    const SurfaceInput& input = run.input;
    if (!input.inventory || run.status == RunStatus::kPartial)
        return {};
    std::vector<DroppedSurface> dropped =
        surfaces_to_drop(input.inventory->surfaces(), voxel_volume(input), run.arguments.selection);
    if (!dropped.empty())
    {
        const std::size_t count = input.inventory->surfaces().size();
        drop_surfaces(dropped, count, result);
        if (result.mesh.faces.empty())
            throw EmptySurfaceError("all " + std::to_string(count) +
                                    " surfaces of the scan are left out by --min-component-volume, "
                                    "--keep-largest or --drop-cavities; nothing was written");
        count_found_pieces(result.pieces, run.statistics);
    }
    return dropped;
}

void finish_shape(MeshRun& run, MeshingResult& result)
{
    const FinishArguments& arguments = run.arguments.finish;
    if (!arguments.changes_shape() || run.status == RunStatus::kPartial)
        return;
    const double edge = typical_edge_length(result.mesh);
    const BoundingSurface surface{
        projection_onto(*run.input.oracle, std::make_shared<const MeshDistance>(result.mesh), edge),
        face_distance_to(*run.input.oracle, edge), relaxation_bound(run, edge)};
    const bool as_it_was = arguments.smooth == 0 && !arguments.decimates(); // else the surface is another one
    result.mesh = finish(std::move(result.mesh), arguments, "", as_it_was ? &surface : nullptr, run.steps);
    result.surface_of_face.clear();
}

void certify_mesh(MeshRun& run, const MeshingResult& result, const std::vector<DroppedSurface>& dropped)
{
    const SurfaceInput& input = run.input;
    if (!input.inventory || run.status == RunStatus::kPartial)
        return;
    const Stopwatch clock;
    const VoxelScale voxel = voxel_scale(input.placement.source_index_from_grid);
    std::optional<std::span<const SurfaceId>> surface_of_face = result.surface_of_face;
    if (result.surface_of_face.size() != result.mesh.faces.size())
        surface_of_face = std::nullopt;
    run.certificate = certify(result.mesh, *input.oracle, input.inventory->surfaces(),
                              {.reach = kReachInVoxels * voxel.mean_side,
                               .floor_radius = run.options.floor_radius,
                               .caps = run.options.close_border ? BorderCaps::kCounted : BorderCaps::kLeftOut,
                               .criteria = {.min_angle_deg = run.options.min_facet_angle_deg,
                                            .max_radius = run.options.max_facet_radius,
                                            .max_center_distance = run.options.max_facet_distance},
                               .dropped = dropped},
                              surface_of_face);
    if (run.status == RunStatus::kDone && broken_promise(*run.certificate))
        run.status = RunStatus::kIncomplete;
    run.timings.certificate = clock.seconds();
}

} // namespace voroprobe
