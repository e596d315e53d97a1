#include "bench/isolated_run.h"

#include <cerrno>
#include <cstring>
#include <ctime>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <type_traits>

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

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
    contestant->mesh();
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

//! Never returns: the child must not run the parent's destructors.
[[noreturn]] void run_as_child(const Entry& contestant, const MeshingTask& task, Checks checks, int pipe_end)
{
    int status = 1;
    try
    {
        const RunRecord record = run(contestant, task, checks);
        if (write(pipe_end, &record, sizeof record) == static_cast<ssize_t>(sizeof record))
            status = 0;
    }
    catch (const std::exception& error)
    {
        std::cerr << contestant.name << ": " << error.what() << std::endl;
    }
    _exit(status);
}

std::string describe_end(int wait_status)
{
    if (WIFSIGNALED(wait_status))
        return std::string("ended by signal ") + strsignal(WTERMSIG(wait_status));
    return "exit status " + std::to_string(WEXITSTATUS(wait_status));
}

} // namespace

RunRecord run_isolated(const Entry& contestant, const MeshingTask& task, Checks checks)
{
    int ends[2];
    if (pipe(ends) != 0)
        throw std::runtime_error("pipe: " + std::string(std::strerror(errno)));
    std::cout.flush();
    const pid_t child = fork();
    if (child < 0)
        throw std::runtime_error("fork: " + std::string(std::strerror(errno)));
    if (child == 0)
    {
        close(ends[0]);
        run_as_child(contestant, task, checks, ends[1]);
    }
    close(ends[1]);

    RunRecord record; // small enough to come through the pipe in one piece
    const bool complete = read(ends[0], &record, sizeof record) == static_cast<ssize_t>(sizeof record);
    close(ends[0]);
    int wait_status = 0;
    waitpid(child, &wait_status, 0);
    if (!complete || wait_status != 0)
        throw std::runtime_error(contestant.name + " did not finish: " + describe_end(wait_status));
    return record;
}

} // namespace voroprobe::bench
