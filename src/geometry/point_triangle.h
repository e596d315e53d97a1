#pragma once

#include <array>

#include "geometry/vec3.h"

namespace voroprobe
{

//! Squared distance from a point to the nearest point of a triangle. Source: Ericson, Real-Time Collision
//! Detection, 2005, Sec. 5.1.5.
double squared_distance_to_triangle(const Point3& p, const std::array<Point3, 3>& corners);

//! Squared radius of the circle through the corners; infinite where they are on a line.
double squared_circumradius(const std::array<Point3, 3>& corners);

} // namespace voroprobe
