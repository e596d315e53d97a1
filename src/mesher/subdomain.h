#pragma once

#include <cstddef>

#include "geometry/vec3.h"

namespace voroprobe
{

//! The part of space between two planes across an axis: low <= coordinate < high.
struct Subdomain
{
    std::size_t axis = 0;
    double low = 0.0;
    double high = 0.0;

    [[nodiscard]] bool holds(const Point3& p) const { return low <= p[axis] && p[axis] < high; }

    //! Whether all of a ball lies in it.
    [[nodiscard]] bool holds(const Point3& center, double radius) const
    {
        return low <= center[axis] - radius && center[axis] + radius < high;
    }
};

} // namespace voroprobe
