#include "compare/competition.h"

#include "compare/one_thread.h"
#include "compare/view_mesh.h"
#include "mesh/topology.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

TriangleMesh without_unused_vertices(const TriangleMesh& mesh)
{
    return with_faces(mesh, std::vector<bool>(mesh.faces.size(), true));
}

//! What is told of a run beside what is true of its mesh.
struct Run
{
    TriangleMesh mesh;
    Json facts;
};

Run run_contestant(const ContestantEntry& entry, const MeshingTask& task)
{
    const auto contestant = entry.make(task);
    RunCosts costs;
    contestant->mesh(costs.clock());
    Json facts = costs.end();
    TriangleMesh mesh = without_unused_vertices(weld(contestant->result()));
    if (mesh.faces.empty())
        throw EmptySurfaceError("it made no face");
    facts["file_size_stl_bytes"] = file_size_stl(mesh.faces.size());
    return {std::move(mesh), facts};
}

class Competition
{
public:
    Competition(const std::vector<ContestantEntry>& entries, const MeshingTask& task,
                const ReferenceSurface& reference, const CompetitionOptions& options)
        : entries_(entries), task_(task), reference_(reference), options_(options),
          most_faces_shown_(faces_per_view(options.faces_shown, entries.size())), outcomes_(entries.size()),
          pool_(options.at_once)
    {
    }

    std::vector<ContestantOutcome> run()
    {
        // Long ones first: one that is begun last leaves the other processors nothing to do.
        for (const Knob knob : {Knob::kCriteria, Knob::kNone})
            for (std::size_t i = 0; i < entries_.size(); ++i)
                if (entries_[i].knob == knob)
                    add(i, task_, ProcessPool::Turn::kLast);
        pool_.run();
        for (std::size_t i = 0; i < entries_.size(); ++i)
            if (outcomes_[i].report.is_null())
                outcomes_[i] =
                    failed_outcome(entries_[i], "it is told how fine Voroprobe's mesh is, and there is none");
        return std::move(outcomes_);
    }

private:
    [[nodiscard]] bool waits_for_ours(std::size_t i) const
    {
        return entries_[i].knob == Knob::kTargetVertices || entries_[i].knob == Knob::kTargetEdge;
    }

    void add(std::size_t i, const MeshingTask& task, ProcessPool::Turn turn)
    {
        pool_.add([this, i, task](ChildOutput& output) { live(entries_[i], task, output); },
                  [this, i](const ChildResult& result) { take(i, result); }, options_.contestant_seconds,
                  turn);
    }

    //! In the child.
    void live(const ContestantEntry& entry, const MeshingTask& task, ChildOutput& output) const
    {
        const OneThread one_thread;
        Run run = run_contestant(entry, task);
        run.facts.update(to_json(measure(run.mesh, reference_, options_.measuring), reference_));
        send_facts(run.facts, output);
        send_view(make_view_mesh(run.mesh, reference_, most_faces_shown_), reference_.voxel, output);
        if (!options_.pictures)
            return;
        transform(run.mesh, reference_.world_from_grid);
        send_picture(run.mesh, reference_.box_world(), output);
    }

    void take(std::size_t i, const ChildResult& result)
    {
        outcomes_[i] = received_outcome(entries_[i], result, options_.pictures);
        if (options_.tell)
            options_.tell(entries_[i].title);
        if (entries_[i].name != kOurs || !outcomes_[i].done())
            return;
        const MeshingTask task = with_targets(task_, outcomes_[i].report);
        for (std::size_t other = 0; other < entries_.size(); ++other)
            if (waits_for_ours(other))
                add(other, task, ProcessPool::Turn::kNext);
    }

    const std::vector<ContestantEntry>& entries_;
    const MeshingTask& task_;
    const ReferenceSurface& reference_;
    const CompetitionOptions& options_;
    std::size_t most_faces_shown_;
    std::vector<ContestantOutcome> outcomes_;
    ProcessPool pool_;
};

} // namespace

MeshingTask with_targets(const MeshingTask& task, const nlohmann::ordered_json& ours)
{
    MeshingTask result = task;
    result.target_vertices = ours.at("vertices");
    result.target_edge_length = ours.at("shape").at("mean_edge_length_mm");
    return result;
}

std::vector<ContestantOutcome> compete(const std::vector<ContestantEntry>& entries, const MeshingTask& task,
                                       const ReferenceSurface& reference, const CompetitionOptions& options)
{
    return Competition(entries, task, reference, options).run();
}

} // namespace voroprobe
