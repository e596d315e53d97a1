#include "compare/label_competition.h"

#include <algorithm>

#include "compare/label_frame.h"
#include "compare/label_measurement.h"
#include "compare/one_thread.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

//! Of all labels, world.
Box3 box_of_labels(const LabelTask& task)
{
    Box3 box;
    for (const std::uint32_t label : task.labels)
    {
        const Box3 one = world_box(task, task.survey->labels()[label].box);
        box.include(one.min);
        box.include(one.max);
    }
    return box;
}

//! In the child.
void live(const LabelContestantEntry& entry, const LabelTask& task, std::size_t most_faces_shown,
          const CompetitionOptions& options, ChildOutput& output)
{
    const OneThread one_thread;
    const auto contestant = entry.make(task);
    RunCosts costs;
    contestant->mesh(costs.clock());
    nlohmann::ordered_json facts = costs.end();
    const std::vector<TriangleMesh> meshes = contestant->take_result();
    if (std::all_of(meshes.begin(), meshes.end(),
                    [](const TriangleMesh& mesh) { return mesh.faces.empty(); }))
        throw EmptySurfaceError("it made no face");
    facts.update(measure_labels(meshes, task, options.measuring));
    facts["file_size_stl_bytes"] = file_size_stl(facts.at("faces"));
    send_facts(facts, output);
    const ViewMesh view = make_label_view(meshes, task, most_faces_shown);
    send_view(view, task.voxel, output);
    if (options.pictures)
        send_picture(view.mesh, box_of_labels(task), output);
}

} // namespace

std::vector<ContestantOutcome> compete_on_labels(const std::vector<LabelContestantEntry>& entries,
                                                 const LabelTask& task, const CompetitionOptions& options)
{
    std::vector<ContestantOutcome> outcomes(entries.size());
    const std::size_t most_faces_shown = faces_per_view(options.faces_shown, entries.size());
    ProcessPool pool(options.at_once);
    for (std::size_t i = 0; i < entries.size(); ++i)
        pool.add([&, i](ChildOutput& output) { live(entries[i], task, most_faces_shown, options, output); },
                 [&, i](const ChildResult& result)
                 {
                     const ContestantEntry told{entries[i].name, entries[i].title, entries[i].description,
                                                Knob::kNone, nullptr};
                     outcomes[i] = received_outcome(told, result, options.pictures);
                     if (options.tell)
                         options.tell(told.title);
                 },
                 options.contestant_seconds);
    pool.run();
    return outcomes;
}

} // namespace voroprobe
