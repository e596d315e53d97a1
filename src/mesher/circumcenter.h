#pragma once

#include <array>

#include "geometry/vec3.h"

namespace voroprobe
{

//! Center of the sphere through four points that are not coplanar. Rounded arithmetic for well-shaped
//! tetrahedra, exact arithmetic for slivers, whose rounded circumcenter would be anywhere. Relative error
//! below 1e-8 of the radius.
Point3 circumcenter(const std::array<Point3, 4>& corners);

} // namespace voroprobe
