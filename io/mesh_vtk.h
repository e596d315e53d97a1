#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Writes VTK's XML poly data to `temporary`, which stands in for `path`: 64-bit coordinates, compressed,
//! comments as a string array of the field data named "comments". \throw OutputError that names `path` and
//! the reason.
void write_vtp(const TriangleMesh& mesh, const std::filesystem::path& temporary,
               const std::filesystem::path& path, const std::vector<std::string>& comments);

//! The formats VTK's readers know. They keep every face, also where the mesh is not manifold.
enum class VtkMeshFormat
{
    kStl,
    kPly,
    kVtp
};

//! Reads polygons, cut into fans of triangles, and strips; vertices as they are in the file. Indices are
//! checked, coordinates are not. \throw InputError with VTK's reason.
TriangleMesh read_with_vtk(const std::filesystem::path& path, VtkMeshFormat format);

} // namespace voroprobe
