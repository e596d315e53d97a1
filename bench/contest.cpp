#include "bench/contest.h"

#include <stdexcept>

#include "support/error.h"

namespace voroprobe::bench
{

namespace
{

bool is_ours_whole(const Standing& standing)
{
    return standing.name == kOurs || standing.name == kOursOnTwo;
}

//! Ours has promised more than the others do: a result that breaks the promise is not worth timing.
void require_promises(const Standing& standing)
{
    const RunRecord& run = standing.checked;
    if (standing.kind == Kind::kMesher && run.faces == 0)
        throw InputError(standing.name + ": empty mesh");
    if (is_ours_whole(standing) &&
        (!standing.closed() || !standing.manifold() || run.misoriented_edges + run.self_intersections != 0))
        throw Error(ExitStatus::kInternal,
                    standing.name + ": mesh is not closed, manifold, oriented and free of crossings (" +
                        std::to_string(run.boundary_edges) + " boundary, " +
                        std::to_string(run.non_manifold_edges) + " non-manifold and " +
                        std::to_string(run.misoriented_edges) + " misoriented edges, " +
                        std::to_string(run.self_intersections) + " crossings)");
}

void require_same(const Standing& standing, const RunRecord& run)
{
    // CGAL orders some of its queues by address: its mesh may differ a little from run to run. Ours must not.
    if (is_ours_whole(standing) &&
        (run.vertices != standing.checked.vertices || run.faces != standing.checked.faces))
        throw Error(ExitStatus::kInternal,
                    standing.name + ": a timed run gave another mesh than the checked one");
}

//! A run that does not finish is the contestant's failure; false then.
bool run_into(RunRecord& record, Standing& standing, const Entry& entry, const MeshingTask& task,
              const ReferenceSurface& reference, Checks checks)
{
    try
    {
        record = run_isolated(entry, task, reference, checks);
        return true;
    }
    catch (const std::runtime_error& error)
    {
        standing.failure = error.what();
        return false;
    }
}

Standing check(const Entry& entry, const MeshingTask& task, const ReferenceSurface& reference)
{
    Standing standing{
        .name = entry.name, .kind = entry.kind, .threads = entry.threads, .checked = {}, .timed = {}};
    if (run_into(standing.checked, standing, entry, task, reference, Checks::kAll))
        require_promises(standing);
    return standing;
}

void add_timed_run(Standing& standing, const Entry& entry, const MeshingTask& task,
                   const ReferenceSurface& reference)
{
    RunRecord run;
    if (standing.failure || !run_into(run, standing, entry, task, reference, Checks::kNone))
        return;
    require_same(standing, run);
    standing.timed.push_back(run);
}

} // namespace

std::vector<Standing> compete(const Entry& ours, const std::vector<Entry>& contestants, MeshingTask task,
                              const ReferenceSurface& reference, std::size_t repeat)
{
    const Standing first = check(ours, task, reference);
    if (first.failure)
        throw Error(ExitStatus::kInternal, *first.failure);
    task.target_vertices = first.checked.vertices;
    task.target_edge_length = first.checked.mean_edge_length;

    std::vector<Standing> standings;
    for (const Entry& entry : contestants)
        standings.push_back(entry.name == ours.name ? first : check(entry, task, reference));
    for (std::size_t round = 0; round < repeat; ++round)
        for (std::size_t i = 0; i < contestants.size(); ++i)
            add_timed_run(standings[i], contestants[i], task, reference);
    return standings;
}

} // namespace voroprobe::bench
