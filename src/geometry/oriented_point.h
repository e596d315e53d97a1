#pragma once

#include "geometry/vec3.h"

namespace voroprobe
{

//! A sample of a surface.
struct OrientedPoint
{
    Point3 position; //!< scan units
    Vec3 normal;     //!< outward, of any length above 0
};

} // namespace voroprobe
