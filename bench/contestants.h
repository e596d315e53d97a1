#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compare/contestant.h"

namespace voroprobe::bench
{

//! A contestant by name.
struct Entry
{
    std::string name;
    std::function<std::unique_ptr<Contestant>(const MeshingTask&)> make;
};

//! CGAL 5.5 make_mesh_3 with Parallel_tag, on as many threads as the task says.
std::unique_ptr<Contestant> make_parallel_mesh_3(const MeshingTask& task, Mesh3Seeding seeding);

//! The same contestant on two threads.
inline std::function<std::unique_ptr<Contestant>(const MeshingTask&)>
on_two_threads(std::unique_ptr<Contestant> (*make)(const MeshingTask&))
{
    return [make](MeshingTask task)
    {
        task.threads = 2;
        return make(task);
    };
}

//! Those that refine, ours first.
inline std::vector<Entry> all_contestants()
{
    return {
        {"voroprobe", make_voroprobe},
        {"voroprobe_2", on_two_threads(make_voroprobe)},
        {"refinement", make_voroprobe_refinement},
        {"refinement_2", on_two_threads(make_voroprobe_refinement)},
        {"surface_mesher",
         [](const MeshingTask& task) { return make_surface_mesher(task, FirstPoints::kSeeded); }},
        {"mesh_3", [](const MeshingTask& task) { return make_mesh_3(task, Mesh3Seeding::kDefault); }},
        {"mesh_3_scan", [](const MeshingTask& task) { return make_mesh_3(task, Mesh3Seeding::kScan); }},
        {"mesh_3_parallel_2", on_two_threads([](const MeshingTask& task)
                                             { return make_parallel_mesh_3(task, Mesh3Seeding::kDefault); })},
        {"mesh_3_parallel_scan_2",
         on_two_threads([](const MeshingTask& task)
                        { return make_parallel_mesh_3(task, Mesh3Seeding::kScan); })}};
}

} // namespace voroprobe::bench
