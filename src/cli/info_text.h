#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/file_lattice.h"

namespace voroprobe
{

//! "  title       text\n"; reports of all commands are made of such lines.
std::string info_line(const std::string& title, const std::string& text);

//! "64 x 64 x 93"
std::string size_text(const std::array<std::size_t, 3>& size);

//! Lines on size, spacing, extent, orientation and origin.
std::string lattice_lines(const FileLattice& lattice);

//! The keys that every input has: path, format, type, size, spacing, direction (columns), origin,
//! orientation.
nlohmann::ordered_json lattice_json(const std::string& path, const std::string& format,
                                    const std::string& stored_type, const FileLattice& lattice);

} // namespace voroprobe
