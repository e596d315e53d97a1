#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compare/contestant.h"

namespace voroprobe
{

//! What makes a contestant's mesh finer or coarser.
enum class Knob
{
    kNone,
    kCriteria,       //!< radius and distance of the task
    kTargetVertices, //!< of the task; unset until ours is done
    kTargetEdge      //!< likewise
};

struct ContestantEntry
{
    std::string name;        //!< of one word: in report.json, options and file names
    std::string title;       //!< for people
    std::string description; //!< what it is and how it is run, one or two sentences
    Knob knob;
    std::function<std::unique_ptr<Contestant>(const MeshingTask&)> make;
};

//! Names that others are told by.
inline constexpr const char* kOurs = "voroprobe";
inline constexpr const char* kReference = "marching_cubes";
inline constexpr const char* kUsualForLabels = "decimated";

//! All that are built in, ours first.
std::vector<ContestantEntry> all_contestants();

//! The task for a mesh so many times as coarse: lengths are multiplied, numbers of vertices divided by the
//! square.
MeshingTask coarser(const MeshingTask& task, Knob knob, double factor);

} // namespace voroprobe
