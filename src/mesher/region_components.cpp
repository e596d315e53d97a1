#include "mesher/region_components.h"

#include <cmath>
#include <limits>
#include <unordered_map>

#include "support/union_find.h"

namespace voroprobe
{
namespace
{

// How many cells ahead the neighbours of the next are asked for: they lie anywhere in memory.
constexpr std::size_t kPrefetchDistance = 16;

double volume(const Triangulation& triangulation, DelaunayCell delaunay_cell)
{
    if (triangulation.is_infinite(delaunay_cell))
        return std::numeric_limits<double>::infinity();
    const auto [a, b, c, d] = corner_positions(delaunay_cell);
    return std::abs(dot(b - a, cross(c - a, d - a))) / 6.0;
}

//! Numbers the cells in the order of memory. Passes in this order are quick, walks from cell to cell are not.
std::vector<DelaunayCell> number_cells(const Triangulation& triangulation)
{
    std::vector<DelaunayCell> cells;
    cells.reserve(triangulation.tds().cells().size());
    for (const DelaunayCell delaunay_cell : triangulation.all_cell_handles())
    {
        delaunay_cell->info().component = static_cast<std::uint32_t>(cells.size());
        cells.push_back(delaunay_cell);
    }
    return cells;
}

//! Joins the numbers of neighbours of one region.
UnionFind join_cells(const std::vector<DelaunayCell>& cells)
{
    UnionFind sets(cells.size());
    for (std::uint32_t c = 0; c < cells.size(); ++c)
    {
        for (int i = 0; c + kPrefetchDistance < cells.size() && i < 4; ++i)
            __builtin_prefetch(&cells[c + kPrefetchDistance]->neighbor(i)->info().region);
        for (int i = 0; i < 4; ++i)
        {
            const DelaunayCellData& next = cells[c]->neighbor(i)->info();
            if (next.component < c && next.region == cells[c]->info().region)
                sets.unite(c, next.component);
        }
    }
    return sets;
}

//! Of the components of regions in several pieces.
void measure(const Triangulation& triangulation, const std::vector<DelaunayCell>& cells,
             std::vector<RegionComponent>& components)
{
    std::unordered_map<Region, int> pieces;
    for (const RegionComponent& component : components)
        ++pieces[component.region];
    std::vector<bool> wanted;
    for (const RegionComponent& component : components)
        wanted.push_back(pieces[component.region] > 1);
    for (const DelaunayCell delaunay_cell : cells)
    {
        const std::uint32_t component = delaunay_cell->info().component;
        if (wanted[component])
            components[component].volume += volume(triangulation, delaunay_cell);
    }
}

} // namespace

std::vector<RegionComponent> find_region_components(const Triangulation& triangulation)
{
    const std::vector<DelaunayCell> cells = number_cells(triangulation);
    UnionFind sets = join_cells(cells);
    std::vector<RegionComponent> components;
    for (std::uint32_t c = 0; c < cells.size(); ++c)
    {
        const std::uint32_t first = sets.find(c); // the smallest of its set: has its component already
        if (first == c)
        {
            cells[c]->info().component = static_cast<std::uint32_t>(components.size());
            components.push_back({cells[c]->info().region, 0.0, cells[c]});
        }
        else
            cells[c]->info().component = cells[first]->info().component;
    }
    measure(triangulation, cells, components);
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
