#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! How far two meshes are apart, both ways, at sampled points; scan units.
struct Deviation
{
    double max = 0.0;
    Point3 max_at; //!< the sample it was found at
    double mean = 0.0;
};

//! Half of the points of each mesh are vertices, middles of sides and centroids, half spread by area. Each
//! distance is exact; between the points there may be larger ones. \pre both have faces with area.
//! Deterministic.
Deviation deviation(const TriangleMesh& a, const TriangleMesh& b, std::size_t samples = 40000);

} // namespace voroprobe
