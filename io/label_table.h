#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh_part.h"

namespace voroprobe
{

//! What a label map's number stands for.
struct LabelEntry
{
    std::int64_t value;
    std::string name; //!< without quotes; may be empty
    std::optional<Color> color = std::nullopt;
};

//! Reads the names and colours of labels from a text file, one label a line, in the order of the file:
//!
//! - ITK-SNAP label descriptions: number, red, green, blue, opacity, visible, mesh shown, "name";
//! - FreeSurfer look-up tables and 3D Slicer colour tables (.ctbl): number, name, red, green, blue, opacity;
//! - number and name, separated by blanks or one of , ; : =.
//!
//! The text is UTF-8, or else Latin-1; the names are UTF-8. Lines that are empty or begin with # or // are
//! comments. \throw InputError with the line where it is none of these, and where a number has two different
//! names.
std::vector<LabelEntry> read_label_table(const std::filesystem::path& path);

} // namespace voroprobe
