#pragma once

#include <string>

#include "cli/mesh_run.h"

namespace voroprobe
{

//! The run for people: what was read, the values used, what was found and made, a line each.
std::string mesh_report(const MeshRun& run);

} // namespace voroprobe
