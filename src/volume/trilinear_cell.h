#pragma once

#include <array>
#include <cstddef>

#include "geometry/vec3.h"

namespace voroprobe
{

//! Values at the corners of one grid cell: corner (x, y, z), each 0 or 1, at index x + 2 y + 4 z. Unit and
//! sign are the caller's; below, a value is *inside* where it is at least 0.
using CellCorners = std::array<double, 8>;

//! A cubic over [0, 1] by its Bernstein coefficients: the first and last are the values at 0 and 1.
using BernsteinCubic = std::array<double, 4>;

//! The roots of a cubic in [0, 1], ascending; at most three.
struct CubicRoots
{
    std::size_t count = 0;
    std::array<double, 3> parameter{};
};

//! From a to b. Exact at both ends, and of the sign of a and b where they agree; a + f (b - a) is neither.
inline double lerp(double a, double b, double f)
{
    return (1.0 - f) * a + f * b;
}

//! The trilinear interpolant at `local`, coordinates in [0, 1]. Exactly the corner's value at a corner; on a
//! face a function of that face's corners alone, the same to the last bit from both sides; of the corners'
//! sign where they all have one. These three make signs agree from grid cell to grid cell, and hold because
//! nothing here is contracted to fused operations.
double trilinear_value(const CellCorners& corners, const Vec3& local);

//! The trilinear interpolant along the segment from `from` to `to`, both with coordinates in [0, 1]; its end
//! coefficients are trilinear_value() of the ends to the last bit.
BernsteinCubic restrict_to_segment(const CellCorners& corners, const Vec3& from, const Vec3& to);

//! True where the coefficients show that the cubic stays on one side: most often, and quickly told.
inline bool stays_on_one_side(const BernsteinCubic& cubic)
{
    const bool inside = cubic[0] >= 0.0;
    return (cubic[1] >= 0.0) == inside && (cubic[2] >= 0.0) == inside && (cubic[3] >= 0.0) == inside;
}

//! Where the cubic changes between inside and outside, to about 1e-12. Even numbers are seen, touching zero
//! is no change, and the number is odd exactly where the end coefficients lie on different sides.
CubicRoots find_sign_changes(const BernsteinCubic& cubic);

} // namespace voroprobe
