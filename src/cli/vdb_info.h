#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/file_lattice.h"
#include "oracles/vdb_oracle.h"

namespace voroprobe
{

//! What `voroprobe info` tells of a sparse grid for people; there is no histogram, most of such a grid has no
//! samples.
std::string vdb_info_text(const std::filesystem::path& path, const VdbSurface& surface);

//! The same for programs.
std::string vdb_info_json(const std::filesystem::path& path, const VdbSurface& surface);

} // namespace voroprobe
