#pragma once

#include <string>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! \throw InputError with `name` where the mesh has no face, a coordinate is not finite, or an edge is on an
//! odd number of faces. Cost: O(n log n).
void require_closed(const TriangleMesh& mesh, const std::string& name);

//! \throw InputError with `name` where two faces meet in more than shared corners and edges; faces without
//! area are not asked. Exact. Cost: O(n log^3 n) for meshes of the usual kind.
void require_no_crossing_faces(const TriangleMesh& mesh, const std::string& name);

} // namespace voroprobe
