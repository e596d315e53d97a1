#pragma once

#include <vector>

#include "geometry/vec3.h"
#include "volume/region.h"

namespace voroprobe
{

//! Where a scan joins parts of one region by a saddle or a sample alone: the way between them may be as thin
//! as a hair. A bridge where the region is inside, a tunnel where it is outside; or, where a sample parts two
//! parts of the other side, a wall.
struct Neck
{
    Point3 middle;                   //!< the saddle, or the sample
    std::vector<Point3> ends;        //!< samples of the region next to it, seen from it along straight ways
    Region region;                   //!< that of middle and ends
    std::vector<SurfaceId> surfaces; //!< that pass beside it: once each
};

} // namespace voroprobe
