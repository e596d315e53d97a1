#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace voroprobe
{

//! The sides of a sample and the 26 around it: bit x + 3 y + 9 z, each 0 to 2, is set where that one is
//! inside. The sample itself is bit 13.
using NeighborhoodCode = std::uint32_t;

inline constexpr std::size_t kCenterBit = 13;

//! The bits of the six samples joined to the center by an edge: -x, +x, -y, +y, -z, +z.
inline constexpr std::array<std::size_t, 6> kEdgeNeighbors{12, 14, 10, 16, 4, 22};

//! The bits of those that share an edge or a face with the center's cube: all but the center and the corners.
inline constexpr NeighborhoodCode kEdgesAndFaces = 0b010111010'111101111'010111010;

//! The bits of the samples where x, y or z is 0, or 2.
inline constexpr std::array<NeighborhoodCode, 3> kLowSide{
    0b001001001'001001001'001001001, 0b000000111'000000111'000000111, 0b000000000'000000000'111111111};
inline constexpr std::array<NeighborhoodCode, 3> kHighSide{kLowSide[0] << 2U, kLowSide[1] << 6U,
                                                           kLowSide[2] << 18U};

//! Those that an edge joins to one of some samples, and these.
constexpr NeighborhoodCode spread_along_edges(NeighborhoodCode samples)
{
    return samples | (samples & ~kHighSide[0]) << 1U | (samples & ~kLowSide[0]) >> 1U |
           (samples & ~kHighSide[1]) << 3U | (samples & ~kLowSide[1]) >> 3U |
           (samples & ~kHighSide[2]) << 9U | (samples & ~kLowSide[2]) >> 9U;
}

//! Whether the members that an edge joins to the center are there, and of one part: joined along edges
//! without the center and the corners.
constexpr bool is_one_part_around_center(NeighborhoodCode members)
{
    constexpr NeighborhoodCode kBesideCenter =
        1U << 12U | 1U << 14U | 1U << 10U | 1U << 16U | 1U << 4U | 1U << 22U;
    members &= kEdgesAndFaces;
    const NeighborhoodCode wanted = members & kBesideCenter;
    NeighborhoodCode reached = wanted & (~wanted + 1); // one of them
    for (NeighborhoodCode before = 0; reached != before && (wanted & ~reached) != 0;)
    {
        before = reached;
        reached = spread_along_edges(reached) & members;
    }
    return wanted != 0 && (wanted & ~reached) == 0;
}

//! Whether the sides stay joined as they are when the center changes sides.
constexpr bool is_simple_center(NeighborhoodCode code)
{
    return is_one_part_around_center(code) && is_one_part_around_center(~code);
}

} // namespace voroprobe
