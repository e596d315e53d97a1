#include "volume/sample_neighborhood.h"

#include <array>
#include <cstdlib>

#include <gtest/gtest.h>

#include "support/random.h"

namespace voroprobe
{
namespace
{

std::array<int, 3> place(std::size_t bit)
{
    return {static_cast<int>(bit % 3), static_cast<int>(bit / 3 % 3), static_cast<int>(bit / 9)};
}

int steps_between(std::size_t a, std::size_t b)
{
    int steps = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        steps += std::abs(place(a)[axis] - place(b)[axis]);
    return steps;
}

//! Parts of the members that share an edge or a face with the center, of those that an edge joins to it.
int parts_around(NeighborhoodCode members)
{
    std::array<bool, 27> seen{};
    const auto visit = [&](const auto& self, std::size_t bit) -> void
    {
        const int off_center = steps_between(bit, kCenterBit);
        if (seen[bit] || (members >> bit & 1U) == 0 || off_center < 1 || off_center > 2)
            return;
        seen[bit] = true;
        for (std::size_t next = 0; next < 27; ++next)
            if (steps_between(bit, next) == 1)
                self(self, next);
    };
    int parts = 0;
    for (const std::size_t start : kEdgeNeighbors)
        if (!seen[start] && (members >> start & 1U) != 0)
        {
            visit(visit, start);
            ++parts;
        }
    return parts;
}

TEST(SampleNeighborhood, is_simple_where_a_flood_finds_one_part_of_each_side)
{
    Random random(1);
    for (int i = 0; i < 20000; ++i)
    {
        NeighborhoodCode code = static_cast<NeighborhoodCode>(random.below(1U << 27U));
        if (i % 3 != 0) // few inside, or few outside
            code = i % 3 == 1 ? code & static_cast<NeighborhoodCode>(random.below(1U << 27U))
                              : code | static_cast<NeighborhoodCode>(random.below(1U << 27U));
        ASSERT_EQ(is_simple_center(code), parts_around(code) == 1 && parts_around(~code) == 1)
            << "code " << code;
    }
}

} // namespace
} // namespace voroprobe
