#pragma once

#include <filesystem>
#include <string>
#include <vector>

//! Inside of io/: the text before the samples of a NRRD file.
namespace voroprobe
{

//! The lines of the header, without line ends. \throw InputError where it is none.
std::vector<std::string> nrrd_header_lines(const std::filesystem::path& path);

//! What follows "name:" (a field) or "name:=" (a key of the writer's own); empty where it is missing.
std::string nrrd_field(const std::vector<std::string>& lines, const std::string& name);

//! Whether 3D Slicer wrote it as a segmentation: it has keys of segments.
bool is_segmentation(const std::vector<std::string>& lines);

} // namespace voroprobe
