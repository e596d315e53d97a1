#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Writes VTK's XML poly data: 64-bit coordinates, compressed, comments as a string array of the field data
//! named "comments". `normals`: of the vertices; empty: none are written. Holds the whole file in memory,
//! about 20 bytes a face. \throw OutputError with VTK's reason; whatever the stream throws.
void write_vtp(const TriangleMesh& mesh, const std::vector<Vec3>& normals, std::ostream& out,
               const std::vector<std::string>& comments);

//! Reads STL, binary or text, as a soup: three vertices of its own for every face. \throw InputError with
//! VTK's reason.
TriangleMesh read_stl(const std::filesystem::path& path);

//! Reads VTK's XML poly data: strips, and polygons cut into fans of triangles; vertices as they are in the
//! file. \throw InputError with VTK's reason.
TriangleMesh read_vtp(const std::filesystem::path& path);

} // namespace voroprobe
