#include "compare/library_versions.h"

#include <CGAL/version.h>
#include <nlohmann/json.hpp>
#include <openvdb/version.h>
#include <vtkVersion.h>

namespace voroprobe
{

nlohmann::ordered_json library_versions()
{
    return {{"CGAL", CGAL_VERSION_STR},
            {"VTK", vtkVersion::GetVTKVersion()},
            {"OpenVDB", OPENVDB_LIBRARY_VERSION_STRING}};
}

} // namespace voroprobe
