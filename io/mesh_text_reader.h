#pragma once

#include <filesystem>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Reads OFF text (with or without colours or normals behind the coordinates), polygons cut into fans of
//! triangles, vertices as they are in the file. Our own, because VTK has no reader for OFF and OpenMesh's
//! leaves out faces that its half-edges cannot represent. \throw InputError
TriangleMesh read_off(const std::filesystem::path& path);

//! Reads vertices and faces of Wavefront OBJ in the same manner. Our own, because VTK's reader rounds to
//! 32-bit floats. \throw InputError
TriangleMesh read_obj(const std::filesystem::path& path);

} // namespace voroprobe
