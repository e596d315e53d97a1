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

//! Those that refine, ours first.
inline std::vector<Entry> all_contestants()
{
    return {{"voroprobe", make_voroprobe},
            {"refinement", make_voroprobe_refinement},
            {"surface_mesher",
             [](const MeshingTask& task) { return make_surface_mesher(task, FirstPoints::kSeeded); }},
            {"mesh_3", [](const MeshingTask& task) { return make_mesh_3(task, Mesh3Seeding::kDefault); }},
            {"mesh_3_scan", [](const MeshingTask& task) { return make_mesh_3(task, Mesh3Seeding::kScan); }}};
}

} // namespace voroprobe::bench
