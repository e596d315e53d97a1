#include "bench/isolated_run.h"

#include <cstring>
#include <ctime>
#include <stdexcept>
#include <type_traits>

#include <malloc.h>

#include "compare/process_pool.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "support/memory.h"
#include "support/stopwatch.h"

namespace voroprobe::bench
{

namespace
{

static_assert(std::is_trivially_copyable_v<RunRecord>);

void add_checks(const TriangleMesh& mesh, double angle_bound_deg, RunRecord& record)
{
    const AngleMeasures angles = measure_angles(mesh);
    record.min_angle_deg = angles.min_deg;
    record.mean_min_angle_deg = angles.mean_min_deg;
    record.faces_below_angle_bound = count_faces_below_angle(mesh, angle_bound_deg);

    const MeshTopology topology = analyze_topology(mesh);
    record.components = topology.components;
    record.boundary_edges = topology.boundary_edges;
    record.non_manifold_edges = topology.non_manifold_edges;
    record.non_manifold_vertices = topology.non_manifold_vertices;
    record.misoriented_edges = topology.misoriented_edges;
    record.area = area(mesh);
}

double cpu_seconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

RunRecord run(const Entry& entry, const MeshingTask& task, Checks checks)
{
    const auto contestant = entry.make(task);
    malloc_trim(0); // memory freed before must not be there to be used again unseen
    RunRecord record;
    const std::size_t before = peak_memory_bytes();

    const double cpu_before = cpu_seconds();
    const Stopwatch stopwatch;
    StageClock stages;
    contestant->mesh(stages);
    record.wall_seconds = stopwatch.seconds();
    record.cpu_seconds = cpu_seconds() - cpu_before;

    record.peak_memory_bytes = peak_memory_bytes() - before;
    const TriangleMesh mesh = contestant->result();
    record.vertices = mesh.vertices.size();
    record.faces = mesh.faces.size();
    if (checks == Checks::kAll)
        add_checks(mesh, task.min_facet_angle_deg, record);
    return record;
}

} // namespace

RunRecord run_isolated(const Entry& contestant, const MeshingTask& task, Checks checks)
{
    const ChildResult result = run_in_child(
        [&](ChildOutput& output)
        {
            const RunRecord record = run(contestant, task, checks);
            output.send({reinterpret_cast<const char*>(&record), sizeof record});
        });
    if (result.failure || result.parts.size() != 1)
        throw std::runtime_error(contestant.name +
                                 " did not finish: " + result.failure.value_or("it sent nothing"));
    RunRecord record;
    std::memcpy(&record, result.parts.front().data(), sizeof record);
    return record;
}

} // namespace voroprobe::bench
