#pragma once

#include "geometry/vec3.h"

namespace voroprobe
{

//! Directed segment; parameter t runs from 0 at `source` to 1 at `target`.
struct Segment3
{
    Point3 source;
    Point3 target;

    [[nodiscard]] constexpr Point3 at(double t) const { return source + t * (target - source); }
};

} // namespace voroprobe
