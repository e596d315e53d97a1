#pragma once

#include "io/mesh_writer.h"

namespace voroprobe
{

//! What --normals asks the writer for. \throw UsageError where the format has no room for them.
VertexNormals normals_argument(bool wanted, MeshFormat format);

} // namespace voroprobe
