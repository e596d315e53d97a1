#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! For each vertex the mean of the ways out of its faces, each weighted by its angle there; unit, zero where
//! no face with area is. Cost: O(n). Source: Thuermer & Wuethrich 1998, Computing vertex normals from
//! polygonal facets.
std::vector<Vec3> vertex_normals(const TriangleMesh& mesh);

} // namespace voroprobe
