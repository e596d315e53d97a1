#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certificate/certificate.h"
#include "certificate/mesh_check.h"
#include "cli/check_arguments.h"
#include "cli/surface_input.h"

namespace voroprobe
{

//! What holding the mesh against a scan gave.
struct ScanComparison
{
    SurfaceInput input;
    Certificate certificate;
};

//! Everything the report and the JSON tell of one run of `voroprobe check`.
struct CheckRun
{
    CheckArguments arguments;
    MeshCheck check;                                //!< in the coordinates of the file
    std::vector<std::string> objects = {};          //!< their names, in the order of the file
    std::optional<PrintCheck> print = std::nullopt; //!< where it was asked for
    std::optional<ScanComparison> scan = std::nullopt;
    double seconds_reading = 0.0; //!< wall clock: the mesh, and the scan
    double seconds_checking = 0.0;
};

//! Why the mesh is not what it should be, in one line; nullopt where it is.
std::optional<std::string> what_is_wrong(const CheckRun& run);

//! For people, a line each; and for programs (README.md, "Checking meshes").
std::string check_report(const CheckRun& run);
std::string check_json(const CheckRun& run);

} // namespace voroprobe
