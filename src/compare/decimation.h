#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! VTK's quadric decimation to about `faces`; fewer than there are, or nothing happens. Cost: some
//! microseconds a face.
TriangleMesh decimate_faces(const TriangleMesh& mesh, std::size_t faces);

} // namespace voroprobe
