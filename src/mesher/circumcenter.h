#pragma once

#include <array>

#include "geometry/vec3.h"

namespace voroprobe
{

//! Center of the sphere through four points that are not coplanar. Rounded arithmetic,
//! double or extended, for all but extreme slivers; exact for those, whose rounded center would be anywhere.
//! Relative error below 1e-8 of the radius.
Point3 circumcenter(const std::array<Point3, 4>& corners);

} // namespace voroprobe
