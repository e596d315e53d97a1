#pragma once

#include <filesystem>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Reads STL, PLY, OBJ, OFF or VTP by extension, vertices at equal coordinates made one (STL stores none
//! shared), polygons cut into triangles. \throw InputError with the path and the reason.
TriangleMesh read_mesh(const std::filesystem::path& path);

} // namespace voroprobe
