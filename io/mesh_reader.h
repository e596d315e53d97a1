#pragma once

#include <filesystem>
#include <vector>

#include "mesh/mesh_part.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Reads STL, PLY, OBJ, OFF, VTP or 3MF by extension, vertices at equal coordinates made one (STL stores none
//! shared), polygons cut into triangles. Of a 3MF file all
//! objects on its plate, in millimetres; those of different objects stay apart. \throw InputError with the
//! path and the reason.
TriangleMesh read_mesh(const std::filesystem::path& path);

//! The same, object by object; formats without objects have one, without a name.
std::vector<MeshPart> read_parts(const std::filesystem::path& path);

} // namespace voroprobe
