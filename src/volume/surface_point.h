#pragma once

#include "geometry/vec3.h"
#include "volume/region.h"

namespace voroprobe
{

struct SurfacePoint
{
    SurfaceId surface;
    Point3 point;
};

} // namespace voroprobe
