#include "bench/isolated_run.h"

#include <algorithm>

#include <malloc.h>
#include <sys/resource.h>

#include "bench/child_record.h"
#include "bench/processor_time.h"
#include "compare/measurement.h"
#include "mesh/topology.h"
#include "support/memory.h"
#include "support/stopwatch.h"
#include "support/thread_limit.h"

namespace voroprobe::bench
{

namespace
{

//! Largest of the programs that this process has waited for, bytes: all that was theirs.
std::size_t peak_memory_of_programs()
{
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024; // Linux counts kilobytes
}

void add_measurement(const TriangleMesh& mesh, const ReferenceSurface& reference, RunRecord& record)
{
    const Measurement measured = measure(mesh, reference, {});
    const MeshCheck& check = measured.check;
    record.mean_edge_length = measured.shapes.mean_edge_length;
    record.min_angle_deg = check.angles.min_deg;
    record.mean_min_angle_deg = check.angles.mean_min_deg;
    record.faces_below_30_deg = check.faces_below_angle_bound.value_or(0);
    record.pieces = check.topology.components;
    record.boundary_edges = check.topology.boundary_edges;
    record.non_manifold_edges = check.topology.non_manifold_edges;
    record.non_manifold_vertices = check.topology.non_manifold_vertices;
    record.misoriented_edges = check.topology.misoriented_edges;
    record.self_intersections = check.self_intersections.size();
    record.area = check.area;
    record.surfaces_there = measured.certificate.surfaces_expected;
    record.surfaces_found = measured.certificate.surfaces_meshed;
    const TwoSidedDistance distance = two_sided(measured.certificate.distance);
    record.distance_max = distance.max;
    record.distance_mean = distance.mean;
    record.distance_root_mean_square = distance.root_mean_square;
}

RunRecord run(const Entry& entry, MeshingTask task, const ReferenceSurface& reference, Checks checks)
{
    const ThreadLimit limit(entry.threads); // for those that take as many threads as there are
    task.threads = entry.threads;
    const auto contestant = entry.make(task);
    malloc_trim(0); // memory freed before must not be there to be used again unseen
    RunRecord record;
    const std::size_t before = peak_memory_bytes();

    const double cpu_before = processor_seconds();
    const Stopwatch stopwatch;
    StageClock stages;
    contestant->mesh(stages);
    record.wall_seconds = stopwatch.seconds();
    record.cpu_seconds = processor_seconds() - cpu_before;

    record.peak_memory_bytes = std::max(peak_memory_bytes() - before, peak_memory_of_programs());
    const TriangleMesh mesh = weld(contestant->result());
    record.vertices = mesh.vertices.size();
    record.faces = mesh.faces.size();
    if (checks == Checks::kAll && entry.kind == Kind::kMesher && !mesh.faces.empty())
        add_measurement(mesh, reference, record);
    return record;
}

} // namespace

RunRecord run_isolated(const Entry& contestant, const MeshingTask& task, const ReferenceSurface& reference,
                       Checks checks)
{
    return record_from_child<RunRecord>(contestant.name,
                                        [&] { return run(contestant, task, reference, checks); });
}

} // namespace voroprobe::bench
