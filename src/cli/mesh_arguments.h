#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "certificate/surface_selection.h"
#include "cli/console_progress.h"
#include "cli/label_arguments.h"
#include "cli/mesh_defaults.h"
#include "cli/output_frame.h"
#include "cli/process_arguments.h"
#include "cli/seeding_arguments.h"
#include "io/volume_reader.h"
#include "mesher/meshing_options.h"
#include "oracles/trilinear_oracle.h"

namespace CLI // NOLINT(readability-identifier-naming): the name of the library
{
class App;
}

namespace voroprobe
{

//! What becomes of the object where it leaves the volume.
enum class BorderFaces
{
    kClosed, //!< faces close it there: the outside of the volume is outside the object
    kOpen    //!< those faces are left out: the mesh has a boundary there
};

//! Everything the user can say to `voroprobe mesh`.
struct MeshArguments
{
    std::filesystem::path input; //!< empty where a formula takes its place
    std::filesystem::path output;
    std::optional<std::string> formula = std::nullopt;
    std::optional<std::string> domain = std::nullopt; //!< of the formula
    ReadOptions read;

    std::optional<double> isovalue = std::nullopt; //!< unset: automatic
    std::optional<InsideIs> inside = std::nullopt; //!< unset: by the kind of file
    BorderFaces border = BorderFaces::kClosed;

    RequestedCriteria criteria;
    IsolatedVertices isolated_vertices = IsolatedVertices::kAllAtOnce;
    std::optional<std::size_t> max_vertices = std::nullopt;
    SeedingArguments finding;

    LabelArguments label_map;

    SurfaceSelection selection;
    FinishArguments finish;

    OutputFrame frame = OutputFrame::kLps;
    std::optional<std::string> format = std::nullopt; //!< unset: by the extension of `output`
    bool normals = false;                             //!< of the vertices, into the file
    std::optional<std::filesystem::path> summary = std::nullopt;

    std::size_t seed = 0; //!< of the rays of Seeding::kRandom; nothing else is random
    std::optional<std::size_t> threads =
        std::nullopt; //!< unset: all there are; any number gives the same bytes
    ProgressMode progress = ProgressMode::kAuto;
    bool quiet = false; //!< nothing on stdout, no automatic bar
};

//! Declares the command's options; `arguments` must outlive the parsing and holds the values after it.
void add_mesh_arguments(CLI::App& command, MeshArguments& arguments);

} // namespace voroprobe
