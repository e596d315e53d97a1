#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <openvdb/openvdb.h>

namespace voroprobe
{

//! Reads one float grid of a .vdb file, all of it: nothing is left to be loaded later. Without a name, the
//! file must hold exactly one. \throw InputError with the path and the reason: missing, not a VDB file,
//! truncated or damaged, no grid of the name, no or several float grids (lists them). Cost: reads the whole
//! file.
openvdb::FloatGrid::Ptr read_float_grid(const std::filesystem::path& path,
                                        const std::optional<std::string>& name);

} // namespace voroprobe
