#pragma once

#include <filesystem>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Reads the vertices and faces of a PLY file, text or binary of either byte order, polygons cut into fans of
//! triangles, vertices as they are in the file; other elements and properties are passed over. Corners are
//! not checked against the vertices. Our own, because VTK's reader rounds 64-bit coordinates to 32 bits and
//! OpenMesh's leaves out faces that its half-edges cannot represent. \throw InputError
TriangleMesh read_ply(const std::filesystem::path& path);

} // namespace voroprobe
