#pragma once

#include <optional>

#include "geometry/vec3.h"

namespace voroprobe
{

//! The circle through the corners of a triangle.
struct Circumcircle
{
    Point3 center;
    Vec3 normal; //!< of its plane, unit; seen from there the corners run counter-clockwise
    double radius;
};

//! nullopt where the triangle has no area.
std::optional<Circumcircle> circumcircle(const Point3& a, const Point3& b, const Point3& c);

} // namespace voroprobe
