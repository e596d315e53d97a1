#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Moves vertices back to their `places` where faces with moved corners have no area any more or cross
//! others, until none does. \pre With all vertices at their places no faces cross; one place for each vertex.
//! Cost: O(n log n) for n faces.
void put_back_where_faces_cross(const std::vector<Point3>& places, TriangleMesh& mesh);

} // namespace voroprobe
