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
};

} // namespace voroprobe
