#include "mesher/region_components.h"

#include <cmath>
#include <limits>
#include <unordered_map>

namespace voroprobe
{
namespace
{

constexpr auto kUnnumbered = std::numeric_limits<std::uint32_t>::max();

double volume(const Triangulation& triangulation, DelaunayCell delaunay_cell)
{
    if (triangulation.is_infinite(delaunay_cell))
        return std::numeric_limits<double>::infinity();
    const auto [a, b, c, d] = corner_positions(delaunay_cell);
    return std::abs(dot(b - a, cross(c - a, d - a))) / 6.0;
}

} // namespace

std::vector<RegionComponent> find_region_components(const Triangulation& triangulation)
{
    for (const DelaunayCell delaunay_cell : triangulation.all_cell_handles())
        delaunay_cell->info().component = kUnnumbered;

    std::vector<RegionComponent> components;
    std::vector<DelaunayCell> front;
    const auto reach = [&](DelaunayCell delaunay_cell)
    {
        delaunay_cell->info().component = static_cast<std::uint32_t>(components.size() - 1);
        components.back().volume += volume(triangulation, delaunay_cell);
        front.push_back(delaunay_cell);
    };
    for (const DelaunayCell first : triangulation.all_cell_handles())
    {
        if (first->info().component != kUnnumbered)
            continue;
        components.push_back({first->info().region, 0.0, first});
        reach(first);
        while (!front.empty())
        {
            const DelaunayCell delaunay_cell = front.back();
            front.pop_back();
            for (int i = 0; i < 4; ++i)
            {
                const DelaunayCell neighbor = delaunay_cell->neighbor(i);
                if (neighbor->info().component == kUnnumbered &&
                    neighbor->info().region == first->info().region)
                    reach(neighbor);
            }
        }
    }
    return components;
}

std::vector<bool> largest_of_each_region(const std::vector<RegionComponent>& components)
{
    std::unordered_map<Region, std::size_t> largest;
    for (std::size_t c = 0; c < components.size(); ++c)
    {
        const auto [entry, added] = largest.try_emplace(components[c].region, c);
        if (!added && components[c].volume > components[entry->second].volume)
            entry->second = c;
    }
    std::vector<bool> is_largest(components.size(), false);
    for (const auto& [region, c] : largest)
        is_largest[c] = true;
    return is_largest;
}

} // namespace voroprobe
