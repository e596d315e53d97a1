#pragma once

#include "geometry/vec3.h"

namespace voroprobe
{

//! Shape of a triangle, told by its smallest angle: 60 degrees at best, 0 for triangles without area.
double smallest_angle_deg(const Point3& a, const Point3& b, const Point3& c);

//! Unit normal, seen from which the corners run counter-clockwise; zero for triangles without area.
Vec3 unit_normal(const Point3& a, const Point3& b, const Point3& c);

} // namespace voroprobe
