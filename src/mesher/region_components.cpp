#include "mesher/region_components.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "support/union_find.h"

namespace voroprobe
{
namespace
{

double volume(const CellTable& table, CellTable::Number cell)
{
    if (table.is_infinite(cell))
        return std::numeric_limits<double>::infinity();
    const auto [a, b, c, d] = corner_positions(table.cell(cell));
    return std::abs(dot(b - a, cross(c - a, d - a))) / 6.0;
}

//! Joins neighbours of one region.
UnionFind join_cells(const CellTable& table)
{
    UnionFind sets(table.size());
    for (CellTable::Number c = 0; c < table.size(); ++c)
    {
        for (const CellTable::Number next : table.neighbors(c))
        {
            if (next < c && table.region(next) == table.region(c))
                sets.unite(c, next);
        }
    }
    return sets;
}

std::vector<std::size_t> count_cells(const RegionComponents& found)
{
    std::vector<std::size_t> counts(found.components.size(), 0);
    for (const std::uint32_t component : found.of_cell)
        ++counts[component];
    return counts;
}

//! Of the components of each region the one with most cells.
std::unordered_map<Region, std::uint32_t> find_longest(const RegionComponents& found,
                                                       const std::vector<std::size_t>& counts)
{
    std::unordered_map<Region, std::uint32_t> longest;
    for (std::uint32_t c = 0; c < found.components.size(); ++c)
    {
        const auto [entry, added] = longest.try_emplace(found.components[c].region, c);
        if (counts[c] > counts[entry->second])
            entry->second = c;
    }
    return longest;
}

//! The components of regions in several pieces: of the one with most cells no more than shows whether it is
//! larger than the others, as a rule a small part.
void measure(const CellTable& table, RegionComponents& found)
{
    const auto longest = find_longest(found, count_cells(found));
    std::vector<bool> is_longest(found.components.size(), false);
    for (const auto& [region, component] : longest)
        is_longest[component] = true;
    for (CellTable::Number c = 0; c < table.size(); ++c)
    {
        if (!is_longest[found.of_cell[c]])
            found.components[found.of_cell[c]].volume += volume(table, c);
    }
    std::vector<double> wanted(found.components.size(), 0.0);
    for (const RegionComponent& component : found.components)
    {
        double& most = wanted[longest.at(component.region)];
        most = std::max(most, component.volume);
    }
    for (CellTable::Number c = 0; c < table.size(); ++c)
    {
        RegionComponent& component = found.components[found.of_cell[c]];
        if (component.volume <= wanted[found.of_cell[c]] && wanted[found.of_cell[c]] > 0.0)
            component.volume += volume(table, c);
    }
}

} // namespace

RegionComponents find_region_components(const CellTable& table)
{
    UnionFind sets = join_cells(table);
    RegionComponents found;
    found.of_cell.reserve(table.size());
    for (CellTable::Number c = 0; c < table.size(); ++c)
    {
        const std::uint32_t first = sets.find(c); // the smallest of its set: has its component already
        if (first == c)
        {
            found.of_cell.push_back(static_cast<std::uint32_t>(found.components.size()));
            found.components.push_back({table.region(c), 0.0, c});
        }
        else
            found.of_cell.push_back(found.of_cell[first]);
    }
    measure(table, found);
    return found;
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
