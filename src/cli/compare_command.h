#pragma once

#include "cli/compare_arguments.h"

namespace voroprobe
{

//! `voroprobe compare`: meshes scans in several ways, holds every mesh against its scan and writes a page for
//! each. \throw UsageError and others as load_surface(); OutputError. A contestant that fails is part of the
//! report, and no error.
void run_compare_command(const CompareArguments& arguments);

} // namespace voroprobe
