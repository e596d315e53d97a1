#pragma once

#include <array>

#include "geometry/vec3.h"

namespace voroprobe
{

//! Where the samples of a lattice lie in the oracle's frame: sample (i, j, k), counted from 0, at first +
//! step .* (i, j, k).
struct LatticeFrame
{
    std::array<int, 3> sample_count; //!< at least 2
    Vec3 step;                       //!< scan units, not 0; negative where an index runs backwards
    Point3 first;

    //! Position of a sample.
    [[nodiscard]] Point3 at(const std::array<int, 3>& index) const
    {
        return {first.x + step.x * index[0], first.y + step.y * index[1], first.z + step.z * index[2]};
    }
};

//! Where the interpolant is 0 between two neighbouring samples of different sides.
inline Point3 edge_crossing(const Point3& a, double height_a, const Point3& b, double height_b)
{
    return a + height_a / (height_a - height_b) * (b - a);
}

} // namespace voroprobe
