#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "volume/volume.h"

namespace voroprobe
{

//! One lattice of 5 x 6 x 7 samples, all different, and its world positions.
struct Phantom
{
    std::array<std::size_t, 3> size{5, 6, 7};
    Vec3 spacing{0.8, 1.1, 2.5};
    Matrix3 rotation;
    Point3 origin{-31.5, 12.25, 103.0};

    [[nodiscard]] std::int16_t value(std::size_t i, std::size_t j, std::size_t k) const
    {
        return static_cast<std::int16_t>(i + 10 * j + 100 * k);
    }
    [[nodiscard]] Point3 position(std::size_t i, std::size_t j, std::size_t k) const
    {
        const auto [x, y, z] =
            std::array{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
        return origin + rotation * Vec3{x * spacing.x, y * spacing.y, z * spacing.z};
    }
};

//! How a file may store the phantom: stored axis s runs along phantom axis `axis[s]`, backwards where
//! `reversed[s]`, and the index of the first sample is `start`.
struct StoredOrder
{
    const char* name;
    std::array<std::size_t, 3> axis;
    std::array<bool, 3> reversed;
    std::array<std::ptrdiff_t, 3> start{0, 0, 0};
};

struct StoredImage
{
    StoredLattice lattice;
    std::vector<std::int16_t> samples;
};

inline StoredImage store(const Phantom& phantom, const StoredOrder& order)
{
    StoredImage image{.lattice = {.size = {}}, .samples = {}};
    StoredLattice& lattice = image.lattice;
    lattice.start = order.start;
    std::array<std::size_t, 3> first{};
    for (std::size_t s = 0; s < 3; ++s)
    {
        const std::size_t a = order.axis[s];
        lattice.size[s] = phantom.size[a];
        lattice.spacing[s] = phantom.spacing[a];
        lattice.direction.column[s] = (order.reversed[s] ? -1.0 : 1.0) * phantom.rotation.column[a];
        first[a] = order.reversed[s] ? phantom.size[a] - 1 : 0;
    }
    lattice.origin = phantom.position(first[0], first[1], first[2]);
    for (std::size_t s = 0; s < 3; ++s)
        lattice.origin -=
            static_cast<double>(order.start[s]) * lattice.spacing[s] * lattice.direction.column[s];

    for (std::size_t w = 0; w < lattice.size[2]; ++w)
        for (std::size_t v = 0; v < lattice.size[1]; ++v)
            for (std::size_t u = 0; u < lattice.size[0]; ++u)
            {
                const std::array stored{u, v, w};
                std::array<std::size_t, 3> at{};
                for (std::size_t s = 0; s < 3; ++s)
                    at[order.axis[s]] = order.reversed[s] ? lattice.size[s] - 1 - stored[s] : stored[s];
                image.samples.push_back(phantom.value(at[0], at[1], at[2]));
            }
    return image;
}

//! Rotation about an axis through the origin (Rodrigues).
inline Matrix3 rotation_about(const Vec3& axis, double angle_deg)
{
    const double angle = angle_deg * std::acos(-1.0) / 180.0;
    const Vec3 n = normalized(axis);
    Matrix3 result;
    for (std::size_t a = 0; a < 3; ++a)
    {
        Vec3 e{0, 0, 0};
        e[a] = 1.0;
        result.column[a] =
            std::cos(angle) * e + std::sin(angle) * cross(n, e) + (1.0 - std::cos(angle)) * dot(n, e) * n;
    }
    return result;
}

//! All 48 orders of the axes, half of them left-handed.
inline std::vector<StoredOrder> all_orders(const std::array<std::ptrdiff_t, 3>& start = {0, 0, 0})
{
    std::vector<StoredOrder> orders;
    std::array<std::size_t, 3> axis{0, 1, 2};
    do
        for (unsigned flips = 0; flips < 8; ++flips)
            orders.push_back({"", axis, {(flips & 1U) != 0, (flips & 2U) != 0, (flips & 4U) != 0}, start});
    while (std::next_permutation(axis.begin(), axis.end()));
    return orders;
}

} // namespace voroprobe
