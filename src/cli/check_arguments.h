#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "certificate/criteria_exceptions.h"
#include "cli/mesh_arguments.h"
#include "cli/output_frame.h"
#include "io/volume_reader.h"
#include "postprocess/print_check.h"
#include "volume/level.h"

namespace CLI // NOLINT(readability-identifier-naming): the name of the library
{
class App;
}

namespace voroprobe
{

//! Everything the user can say to `voroprobe check`.
struct CheckArguments
{
    std::filesystem::path mesh;
    FaceCriteria criteria; //!< whose exceptions are counted; radius and center distance need a scan
    std::optional<std::filesystem::path> json = std::nullopt;
    bool quiet = false; //!< nothing on stdout

    bool printable = false; //!< judge whether it can be printed, by these options
    PrintOptions print;

    std::optional<std::filesystem::path> against = std::nullopt; //!< the scan; all below go with it only
    ReadOptions read;
    std::optional<double> isovalue = std::nullopt; //!< unset: automatic
    std::optional<InsideIs> inside = std::nullopt; //!< unset: by the kind of file
    BorderFaces border = BorderFaces::kClosed;
    OutputFrame frame = OutputFrame::kLps; //!< of the mesh
    std::size_t samples = 20000;           //!< points of the mesh; half as many of the surface
};

//! Declares the command's options; `arguments` must outlive the parsing and holds the values after it.
void add_check_arguments(CLI::App& command, CheckArguments& arguments);

} // namespace voroprobe
