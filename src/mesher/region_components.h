#pragma once

#include <cstdint>
#include <vector>

#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! A maximal set of Delaunay cells of one region, joined through facets.
struct RegionComponent
{
    Region region;
    double volume; //!< cubed scan units; infinite for the one that reaches to infinity; 0 for the only one of
                   //!< its region
    DelaunayCell first; //!< one of its cells
};

//! Numbers the components of all regions and writes each cell's into DelaunayCellData::component. Cost:
//! O(Delaunay cells).
std::vector<RegionComponent> find_region_components(const Triangulation& triangulation);

//! Of each component whether it is the largest of its region: the one that stands for it.
std::vector<bool> largest_of_each_region(const std::vector<RegionComponent>& components);

} // namespace voroprobe
