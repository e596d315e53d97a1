#include "compare/competition.h"

#include <algorithm>
#include <chrono>

#include <malloc.h>

#include "compare/one_thread.h"
#include "compare/picture.h"
#include "compare/view_mesh.h"
#include "mesh/topology.h"
#include "support/error.h"
#include "support/memory.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

//! Views of fewer faces would show nothing.
constexpr std::size_t kFewestFacesShown = 50000;

//! What a child sends, in this order.
enum Part : std::size_t
{
    kFacts,
    kView,
    kViewFacts,
    kPicture
};

std::size_t file_size_stl(std::size_t faces)
{
    return 84 + 50 * faces; // header and count, 50 bytes a face
}

Json time_json(const std::vector<Stage>& stages)
{
    Json list = Json::array();
    double cpu = 0.0;
    double wall = 0.0;
    for (const Stage& stage : stages)
    {
        list.push_back(
            {{"name", stage.name}, {"cpu_seconds", stage.cpu_seconds}, {"wall_seconds", stage.wall_seconds}});
        cpu += stage.cpu_seconds;
        wall += stage.wall_seconds;
    }
    return {{"cpu_seconds", cpu}, {"wall_seconds", wall}, {"stages", list}};
}

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
    malloc_trim(0); // memory freed before must not be there to be used again unseen
    const std::size_t before = peak_memory_bytes();
    StageClock clock;
    contestant->mesh(clock);
    const Json time = time_json(clock.end());
    const std::size_t peak = peak_memory_bytes() - before;
    TriangleMesh mesh = without_unused_vertices(weld(contestant->result()));
    if (mesh.faces.empty())
        throw EmptySurfaceError("it made no face");
    const Json facts = {{"time", time},
                        {"peak_memory_bytes", peak},
                        {"file_size_stl_bytes", file_size_stl(mesh.faces.size())}};
    return {std::move(mesh), facts};
}

void send_view(const TriangleMesh& mesh, const ReferenceSurface& reference, std::size_t most_faces,
               ChildOutput& output)
{
    const ViewMesh view = make_view_mesh(mesh, reference, most_faces);
    output.send(pack(view, kLongestDistanceInVoxels * reference.voxel));
    const Json facts = {{"faces", view.mesh.faces.size()},
                        {"faces_of_whole", view.faces_of_whole},
                        {"decimated", view.decimated()}};
    output.send(facts.dump());
}

void send_picture(TriangleMesh mesh, const ReferenceSurface& reference, ChildOutput& output)
{
    transform(mesh, reference.world_from_grid);
    output.send(draw_picture(mesh, reference.box_world()));
}

Json entry_json(const ContestantEntry& entry, const char* status)
{
    return {
        {"name", entry.name}, {"title", entry.title}, {"description", entry.description}, {"status", status}};
}

ContestantOutcome failed(const ContestantEntry& entry, const std::string& reason)
{
    ContestantOutcome outcome{
        .entry = entry, .report = entry_json(entry, "failed"), .view = {}, .picture = {}};
    outcome.report["reason"] = reason;
    return outcome;
}

//! A child that fails after its facts has lost its view or its picture, and the report says so.
ContestantOutcome outcome_of(const ContestantEntry& entry, const ChildResult& result, bool pictures)
{
    const std::string reason = result.failure.value_or("it sent nothing");
    if (result.parts.size() <= kFacts)
        return failed(entry, reason);
    ContestantOutcome outcome{.entry = entry, .report = entry_json(entry, "done"), .view = {}, .picture = {}};
    outcome.report.update(Json::parse(result.parts[kFacts]));
    if (result.parts.size() > kViewFacts)
    {
        outcome.view = result.parts[kView];
        outcome.report["view"] = Json::parse(result.parts[kViewFacts]);
    }
    else
        outcome.report["view"] = {{"missing", reason}};
    if (result.parts.size() > kPicture)
        outcome.picture = result.parts[kPicture];
    else if (pictures)
        outcome.report["picture_missing"] = reason;
    return outcome;
}

class Competition
{
public:
    Competition(const std::vector<ContestantEntry>& entries, const MeshingTask& task,
                const ReferenceSurface& reference, const CompetitionOptions& options)
        : entries_(entries), task_(task), reference_(reference), options_(options),
          most_faces_shown_(
              std::max(kFewestFacesShown, options.faces_shown / std::max<std::size_t>(entries.size(), 1))),
          outcomes_(entries.size()), pool_(options.at_once)
    {
    }

    std::vector<ContestantOutcome> run()
    {
        for (std::size_t i = 0; i < entries_.size(); ++i)
            if (!waits_for_ours(i))
                add(i, task_);
        pool_.run();
        for (std::size_t i = 0; i < entries_.size(); ++i)
            if (outcomes_[i].report.is_null())
                outcomes_[i] =
                    failed(entries_[i], "it is told how fine Voroprobe's mesh is, and there is none");
        return std::move(outcomes_);
    }

private:
    [[nodiscard]] bool waits_for_ours(std::size_t i) const
    {
        return entries_[i].knob == Knob::kTargetVertices || entries_[i].knob == Knob::kTargetEdge;
    }

    void add(std::size_t i, const MeshingTask& task)
    {
        pool_.add([this, i, task](ChildOutput& output) { live(entries_[i], task, output); },
                  [this, i](const ChildResult& result) { take(i, result); }, options_.contestant_seconds);
    }

    //! In the child.
    void live(const ContestantEntry& entry, const MeshingTask& task, ChildOutput& output) const
    {
        const OneThread one_thread;
        Run run = run_contestant(entry, task);
        run.facts.update(to_json(measure(run.mesh, reference_, options_.measuring), reference_));
        output.send(run.facts.dump());
        send_view(run.mesh, reference_, most_faces_shown_, output);
        if (options_.pictures)
            send_picture(std::move(run.mesh), reference_, output);
    }

    void take(std::size_t i, const ChildResult& result)
    {
        outcomes_[i] = outcome_of(entries_[i], result, options_.pictures);
        if (options_.tell)
            options_.tell(entries_[i].title);
        if (entries_[i].name != kOurs || !outcomes_[i].done())
            return;
        const MeshingTask task = with_targets(task_, outcomes_[i].report);
        for (std::size_t other = 0; other < entries_.size(); ++other)
            if (waits_for_ours(other))
                add(other, task);
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
