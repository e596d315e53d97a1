#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/process_steps.h"

namespace voroprobe
{

//! Everything the report and the summary tell of one run of `voroprobe process`.
struct ProcessRun
{
    ProcessArguments arguments;
    std::size_t objects_read = 0;
    StepFacts before; //!< of all objects together
    std::vector<StepReport> steps = {};
    std::size_t objects_written = 0;
    StepFacts after = {};
    std::optional<std::string> wrong = std::nullopt; //!< with what was written
    std::vector<std::filesystem::path> written = {};
};

//! "70,434 faces, 74 pieces, closed, no crossings, smallest angle ..."
std::string facts_text(const StepFacts& facts);

//! For programs (README.md, "Working on meshes").
std::string process_json(const ProcessRun& run);
nlohmann::ordered_json steps_json(const std::vector<StepReport>& steps);

} // namespace voroprobe
