#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/label_arguments.h"
#include "cli/mesh_defaults.h"
#include "cli/output_frame.h"
#include "io/volume_reader.h"
#include "volume/level.h"

namespace CLI // NOLINT(readability-identifier-naming): the name of the library
{
class App;
}

namespace voroprobe
{

//! A mesh the user brings: --with NAME=FILE.
struct BroughtMesh
{
    std::string name; //!< letters, digits, '-' and '_'
    std::filesystem::path path;
};

//! Everything the user can say to `voroprobe compare`.
struct CompareArguments
{
    std::vector<std::filesystem::path> inputs;
    std::filesystem::path output; //!< a page; with several scans a folder of pages
    ReadOptions read;
    std::optional<double> isovalue = std::nullopt; //!< unset: automatic
    std::optional<InsideIs> inside = std::nullopt; //!< unset: above
    RequestedCriteria criteria;
    LabelArguments label_map;

    std::optional<std::vector<std::string>> contestants = std::nullopt; //!< unset: all
    std::vector<BroughtMesh> with;
    OutputFrame frame = OutputFrame::kLps; //!< of the meshes brought
    double contestant_seconds = 120.0;
    double sweep_seconds = 16.0; //!< processor time for equal accuracy; 0: left out
    bool pictures = true;
    std::size_t samples = 20000;                       //!< points of each mesh; half as many of the scan
    std::optional<std::size_t> at_once = std::nullopt; //!< unset: as many as there are processors
    std::vector<std::string> command;                  //!< the words of the command line, for the report
    bool quiet = false;                                //!< nothing on stdout, no line of progress
};

//! Declares the command's options; `arguments` must outlive the parsing and holds the values after it.
void add_compare_arguments(CLI::App& command, CompareArguments& arguments);

} // namespace voroprobe
