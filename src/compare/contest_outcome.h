#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "compare/contestant_list.h"
#include "compare/process_pool.h"
#include "compare/run_costs.h"
#include "compare/view_mesh.h"

namespace voroprobe
{

//! What came of one contestant.
struct ContestantOutcome
{
    ContestantEntry entry;
    nlohmann::ordered_json
        report;          //!< its part of report.json: "status" is "done" or "failed", with a "reason"
    std::string view;    //!< packed for the page; empty where there is none
    std::string picture; //!< PNG; empty where there is none

    [[nodiscard]] bool done() const { return report.at("status") == "done"; }
};

ContestantOutcome failed_outcome(const ContestantEntry& entry, const std::string& reason);

//! What a contestant's process sends, in this order: facts for the report, then the view, then the picture.
//! One that fails after its facts has lost its view or its picture, and the report says so.
void send_facts(const nlohmann::ordered_json& facts, ChildOutput& output);
void send_view(const ViewMesh& view, double voxel, ChildOutput& output);

//! `mesh`: world. `box`: what is in the picture, world.
void send_picture(const TriangleMesh& mesh, const Box3& box, ChildOutput& output);

//! What was sent. `pictures`: whether one was wanted.
ContestantOutcome received_outcome(const ContestantEntry& entry, const ChildResult& result, bool pictures);

//! Of a binary STL file, bytes.
std::size_t file_size_stl(std::size_t faces);

//! How many faces each of so many views may have, of those that all may have together. At least so many that
//! something can be seen.
std::size_t faces_per_view(std::size_t faces_shown, std::size_t views);

} // namespace voroprobe
