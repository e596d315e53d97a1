#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Other places for vertices of a mesh, in the order in which they are to be tried.
using OtherPlaces = std::map<std::uint32_t, std::vector<Point3>>;

//! Where faces cross others or have no area, moves those of their vertices that have another place there,
//! until none do or no place is left. \pre faces without such a vertex do not cross each other. Cost: O(n log
//! n) for n faces, if there are any places.
void settle_crossing_faces(OtherPlaces places, TriangleMesh& mesh);

} // namespace voroprobe
