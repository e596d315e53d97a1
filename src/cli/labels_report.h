#pragma once

#include <string>

#include "cli/labels_run.h"

namespace voroprobe
{

//! For people: what was read and done, and a table of the labels; of many, the largest and all that are not
//! as promised.
std::string labels_report(const LabelsRun& run);

//! The same of all labels, as JSON (README.md, "Label maps").
std::string labels_summary_json(const LabelsRun& run);

} // namespace voroprobe
