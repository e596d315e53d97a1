#pragma once

#include <array>

#include "geometry/vec3.h"

namespace voroprobe
{

using Tetrahedron = std::array<Point3, 4>;

inline Point3 centroid(const Tetrahedron& p)
{
    return 0.25 * (p[0] + p[1] + p[2] + p[3]);
}

double longest_edge(const Tetrahedron& p);

//! The least distance of a corner from the plane of the others.
double least_altitude(const Tetrahedron& p);

} // namespace voroprobe
