#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "io/mesh_writer.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Writes STL, PLY, OBJ or OFF through OpenMesh, coordinates rounded to 32-bit floats (text: all digits of
//! that float). `normals`: of the vertices, for PLY and OBJ; empty: none are written. \pre the format is not
//! VTP; fewer than 2^31 vertices and faces. \throw OutputError where OpenMesh gives up; whatever the stream
//! throws.
void write_with_openmesh(const TriangleMesh& mesh, const std::vector<Vec3>& normals, std::ostream& out,
                         MeshFormat format, const std::vector<std::string>& comments);

} // namespace voroprobe
