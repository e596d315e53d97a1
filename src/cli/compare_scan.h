#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/compare_arguments.h"
#include "compare/scan_report.h"

namespace voroprobe
{

//! Reads the scan and runs the contestants. `stem`: names of files beside the page begin with it.
//! `no_pictures`: why there will be none; unset: there will be, where they are wanted. \throw as
//! load_surface().
ScanReport compare_scan(const CompareArguments& arguments, const std::filesystem::path& input,
                        const std::string& stem, const std::optional<std::string>& no_pictures);

} // namespace voroprobe
