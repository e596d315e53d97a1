#pragma once

#include <filesystem>
#include <string>

#include "cli/mesh_run.h"

namespace voroprobe
{

//! The run as JSON, two spaces of indentation, keys always the same and in the same order (README.md,
//! "Summary").
std::string summary_json(const MeshRun& run);

//! Writes text to a temporary name beside `path` and renames: the target is either whole or untouched. \throw
//! OutputError.
void write_text(const std::filesystem::path& path, const std::string& text);

} // namespace voroprobe
