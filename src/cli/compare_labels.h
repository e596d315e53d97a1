#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/compare_arguments.h"
#include "compare/scan_report.h"

namespace voroprobe
{

//! As compare_scan(), of a label map. \throw as read_label_map(), chosen_labels().
ScanReport compare_labels(const CompareArguments& arguments, const std::filesystem::path& path,
                          const std::string& stem, const std::optional<std::string>& no_pictures);

//! \throw UsageError where an option does not go with --labels, or with its absence.
void check_compared_labels(const CompareArguments& arguments, const std::filesystem::path& path);

} // namespace voroprobe
