#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/box3.h"

namespace voroprobe
{

//! A box cut into cubes. Points beyond it count to the cubes next to them.
class CubeGrid
{
public:
    using Cube = std::array<std::int64_t, 3>;

    //! `side`: above 0, and so large that the cubes are fewer than 2^63.
    CubeGrid(const Box3& box, double side) : min_(box.min), side_(side)
    {
        const Vec3 extent = box.extent();
        for (std::size_t axis = 0; axis < 3; ++axis)
            count_[axis] = static_cast<std::int64_t>(extent[axis] / side) + 1;
    }

    [[nodiscard]] Cube cube(const Point3& p) const
    {
        Cube cube{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            cube[axis] = std::clamp(static_cast<std::int64_t>((p[axis] - min_[axis]) / side_),
                                    std::int64_t{0}, count_[axis] - 1);
        return cube;
    }

    [[nodiscard]] bool has(const Cube& cube) const
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (cube[axis] < 0 || cube[axis] >= count_[axis])
                return false;
        return true;
    }

    //! Below count(). \pre has(cube)
    [[nodiscard]] std::int64_t number(const Cube& cube) const
    {
        return cube[0] + count_[0] * (cube[1] + count_[1] * cube[2]);
    }

    [[nodiscard]] std::int64_t count() const { return count_[0] * count_[1] * count_[2]; }

private:
    Point3 min_;
    double side_;
    Cube count_{};
};

} // namespace voroprobe
