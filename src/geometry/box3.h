#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "geometry/segment3.h"
#include "geometry/vec3.h"

namespace voroprobe
{

//! Closed axis-aligned box; empty when default-constructed.
struct Box3
{
    Point3 min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
               std::numeric_limits<double>::infinity()};
    Point3 max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
               -std::numeric_limits<double>::infinity()};

    [[nodiscard]] constexpr bool empty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }
    [[nodiscard]] constexpr Vec3 extent() const { return max - min; }
    [[nodiscard]] constexpr Point3 center() const { return 0.5 * (min + max); }
    [[nodiscard]] double diagonal() const { return norm(extent()); }

    [[nodiscard]] constexpr bool contains(const Point3& p) const
    {
        return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y && p.z >= min.z && p.z <= max.z;
    }

    constexpr void include(const Point3& p)
    {
        min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
    }

    //! The box grown by `margin` on every side.
    [[nodiscard]] constexpr Box3 expanded(double margin) const
    {
        const Vec3 m{margin, margin, margin};
        return {min - m, max + m};
    }
};

//! What two boxes have in common; empty where that is nothing.
constexpr Box3 intersection(const Box3& a, const Box3& b)
{
    return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y), std::max(a.min.z, b.min.z)},
            {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y), std::min(a.max.z, b.max.z)}};
}

//! Parameters of the part of `segment` inside `box`, 0 <= first <= second <= 1; nullopt when they do not
//! meet. Exact comparisons of rounded parameters: the ends lie on the box to within rounding of the segment's
//! length. Cost: O(1). Source: Kay & Kajiya 1986 (slabs).
struct ParameterRange
{
    double first;
    double second;
};
std::optional<ParameterRange> clip_to_box(const Segment3& segment, const Box3& box);

} // namespace voroprobe
