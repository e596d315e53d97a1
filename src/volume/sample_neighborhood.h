#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace voroprobe
{

//! The sides of a sample and the 26 around it: bit x + 3 y + 9 z, each 0 to 2, is set where that one is
//! inside. The sample itself is bit 13.
using NeighborhoodCode = std::uint32_t;

inline constexpr std::size_t kCenterBit = 13;
inline constexpr NeighborhoodCode kWholeNeighborhood = (NeighborhoodCode{1} << 27U) - 1;

//! The bits of the six samples joined to the center by an edge: -x, +x, -y, +y, -z, +z.
inline constexpr std::array<std::size_t, 6> kEdgeNeighbors{12, 14, 10, 16, 4, 22};

//! The bits joined to each by an edge, of those that share an edge or a face with the center. The center and
//! the corners have none.
constexpr std::array<NeighborhoodCode, 27> neighborhood_edges()
{
    const auto is_near = [](std::size_t bit)
    {
        const std::size_t off_center =
            (bit % 3 != 1 ? 1U : 0U) + (bit / 3 % 3 != 1 ? 1U : 0U) + (bit / 9 != 1 ? 1U : 0U);
        return off_center == 1 || off_center == 2;
    };
    std::array<NeighborhoodCode, 27> joined{};
    for (std::size_t a = 0; a < 27; ++a)
        for (std::size_t b = a + 1; b < 27; ++b)
        {
            const bool edge = (b - a == 1 && a / 3 == b / 3) || (b - a == 3 && a / 9 == b / 9) || b - a == 9;
            if (!edge || !is_near(a) || !is_near(b))
                continue;
            joined[a] |= NeighborhoodCode{1} << b;
            joined[b] |= NeighborhoodCode{1} << a;
        }
    return joined;
}

//! Parts of `members`, joined along edges without the center, that an edge joins to the center.
inline int parts_around_center(NeighborhoodCode members)
{
    static constexpr std::array<NeighborhoodCode, 27> kJoined = neighborhood_edges();
    int parts = 0;
    NeighborhoodCode reached = 0;
    for (const std::size_t start : kEdgeNeighbors)
    {
        NeighborhoodCode front = members & ~reached & NeighborhoodCode{1} << start;
        parts += front != 0 ? 1 : 0;
        while (front != 0)
        {
            reached |= front;
            NeighborhoodCode next = 0;
            for (; front != 0; front &= front - 1)
                next |= kJoined[static_cast<std::size_t>(std::countr_zero(front))];
            front = next & members & ~reached;
        }
    }
    return parts;
}

//! Whether the sides stay joined as they are when the center changes sides.
inline bool is_simple_center(NeighborhoodCode code)
{
    return parts_around_center(code) == 1 && parts_around_center(~code & kWholeNeighborhood) == 1;
}

} // namespace voroprobe
