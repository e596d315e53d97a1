#include "cli/vdb_info.h"

#include <nlohmann/json.hpp>

#include "cli/info_text.h"
#include "cli/json_values.h"
#include "cli/number_text.h"

namespace voroprobe
{

namespace
{

FileLattice lattice_of(const VdbSurface& surface)
{
    return file_lattice(surface.active_size, {surface.world_from_grid, surface.source_index_from_grid});
}

std::string side_name(InsideIs inside)
{
    return inside == InsideIs::kAbove ? "above" : "below";
}

} // namespace

std::string vdb_info_text(const std::filesystem::path& path, const VdbSurface& surface)
{
    return info_line("file", path.string() + " (OpenVDB, " + surface.stored_type + ")") +
           info_line("grid", surface.grid_name + ", " + surface.grid_class) +
           lattice_lines(lattice_of(surface)) +
           info_line("values",
                     number_text(surface.min) + " to " + number_text(surface.max) + " (active voxels)") +
           info_line("isovalue", number_text(surface.isovalue) + ", inside " + side_name(surface.inside) +
                                     " (usual for a " + surface.grid_class + ")");
}

std::string vdb_info_json(const std::filesystem::path& path, const VdbSurface& surface)
{
    nlohmann::ordered_json json = lattice_json(path.string(), "OpenVDB " + surface.grid_class,
                                               surface.stored_type, lattice_of(surface));
    json["grid"] = surface.grid_name;
    json["min"] = surface.min;
    json["max"] = surface.max;
    json["suggested_isovalues"] =
        nlohmann::ordered_json::array({{{"value", surface.isovalue},
                                        {"source", "usual for a " + surface.grid_class},
                                        {"inside", side_name(surface.inside)}}});
    json["warnings"] = surface.warnings;
    return json_text(json) + '\n';
}

} // namespace voroprobe
