#include "mesher/cell_table.h"

namespace voroprobe
{
namespace
{

// How many cells ahead the neighbours of the next are asked for: they lie anywhere in memory.
constexpr std::size_t kPrefetchDistance = 16;

} // namespace

CellTable::CellTable(const Triangulation& triangulation)
{
    const std::size_t count = triangulation.tds().cells().size();
    cells_.reserve(count);
    neighbors_.reserve(count);
    is_infinite_.reserve(count);
    regions_.reserve(count);
    for (const DelaunayCell delaunay_cell : triangulation.all_cell_handles())
    {
        delaunay_cell->info().scratch = size();
        cells_.push_back(delaunay_cell);
        regions_.push_back(delaunay_cell->info().region);
        is_infinite_.push_back(triangulation.is_infinite(delaunay_cell));
    }
    for (std::size_t c = 0; c < cells_.size(); ++c)
    {
        for (int i = 0; c + kPrefetchDistance < cells_.size() && i < 4; ++i)
            __builtin_prefetch(&cells_[c + kPrefetchDistance]->neighbor(i)->info().scratch);
        std::array<Number, 4> around{};
        for (int i = 0; i < 4; ++i)
            around[static_cast<std::size_t>(i)] = cells_[c]->neighbor(i)->info().scratch;
        neighbors_.push_back(around);
    }
}

void CellTable::refresh_regions()
{
    for (std::size_t c = 0; c < cells_.size(); ++c)
        regions_[c] = cells_[c]->info().region;
}

} // namespace voroprobe
