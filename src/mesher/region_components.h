#pragma once

#include <cstdint>
#include <vector>

#include "mesher/cell_table.h"

namespace voroprobe
{

//! A maximal set of Delaunay cells of one region, joined through facets.
struct RegionComponent
{
    Region region;
    double volume;           //!< cubed scan units; of the largest of its region enough to tell that it is
    CellTable::Number first; //!< one of its cells
};

//! The components of all regions, and each cell's.
struct RegionComponents
{
    std::vector<RegionComponent> components;
    std::vector<std::uint32_t> of_cell; //!< index into components, by the cell's number
};

//! Cost: O(Delaunay cells).
RegionComponents find_region_components(const CellTable& table);

//! Of each component whether it is the largest of its region: the one that stands for it.
std::vector<bool> largest_of_each_region(const std::vector<RegionComponent>& components);

} // namespace voroprobe
