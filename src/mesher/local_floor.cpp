#include "mesher/local_floor.h"

#include <algorithm>
#include <cmath>

namespace voroprobe
{

LocalFloor::Cube LocalFloor::cube_of(const Point3& p) const
{
    return {static_cast<std::int64_t>(std::floor(p.x * inverse_cube_side_)),
            static_cast<std::int64_t>(std::floor(p.y * inverse_cube_side_)),
            static_cast<std::int64_t>(std::floor(p.z * inverse_cube_side_))};
}

// 21 bits along each axis: cubes two million apart share a key, and thereby a floor.
std::uint64_t LocalFloor::key(const Cube& cube)
{
    constexpr std::uint64_t kMask = (std::uint64_t{1} << 21U) - 1;
    return (static_cast<std::uint64_t>(cube.x) & kMask) |
           ((static_cast<std::uint64_t>(cube.y) & kMask) << 21U) |
           ((static_cast<std::uint64_t>(cube.z) & kMask) << 42U);
}

bool LocalFloor::lower(const Point3& p, int round)
{
    const double wanted = squared_base_ * std::pow(0.25, std::min(round, kRounds));
    const Cube center = cube_of(p);
    bool changed = false;
    for (std::int64_t dz = -1; dz <= 1; ++dz)
        for (std::int64_t dy = -1; dy <= 1; ++dy)
            for (std::int64_t dx = -1; dx <= 1; ++dx)
            {
                const auto [entry, added] = squared_floor_of_cube_.try_emplace(
                    key({center.x + dx, center.y + dy, center.z + dz}), squared_base_);
                changed = changed || entry->second > wanted;
                entry->second = std::min(entry->second, wanted);
            }
    return changed;
}

} // namespace voroprobe
