#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "cli/compare_arguments.h"
#include "compare/competition_options.h"
#include "compare/scan_report.h"

namespace voroprobe
{

//! What the report tells of a run whatever was read: names, version, command, date.
ScanFacts run_facts(const CompareArguments& arguments, const std::filesystem::path& path);

//! `angle_bound_deg`: that of the criteria. `pictures_fail`: there is no display to draw them on.
CompetitionOptions competition_options(const CompareArguments& arguments, double angle_bound_deg,
                                       bool pictures_fail, std::function<void(const std::string&)> tell);

//! Whether the user wants a contestant.
bool takes_part(const CompareArguments& arguments, const std::string& name);

} // namespace voroprobe
