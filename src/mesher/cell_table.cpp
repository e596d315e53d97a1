#include "mesher/cell_table.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "support/check.h"

namespace voroprobe
{
namespace
{

// How many cells ahead the neighbours of the next are asked for: they lie anywhere in memory.
constexpr std::size_t kPrefetchDistance = 16;

// That one thread takes in in a row.
constexpr std::size_t kCellsAtOnce = 4096;

// Room for so small a share of more cells.
constexpr std::size_t kRoomShare = 16;

std::array<std::uint32_t, 4> corner_indices(DelaunayCell delaunay_cell)
{
    return {delaunay_cell->vertex(0)->info().index, delaunay_cell->vertex(1)->info().index,
            delaunay_cell->vertex(2)->info().index, delaunay_cell->vertex(3)->info().index};
}

constexpr auto kNewCell = std::numeric_limits<CellTable::Number>::max();

} // namespace

CellTable::CellTable(const Triangulation& triangulation, const Workers& workers)
    : triangulation_(&triangulation), vertices_seen_(triangulation.number_of_vertices())
{
    const std::size_t count = triangulation.tds().cells().size();
    make_room_for(count);
    for (const DelaunayCell delaunay_cell : triangulation.all_cell_handles())
    {
        delaunay_cell->info().scratch = size();
        cells_.push_back(delaunay_cell);
        regions_.push_back(delaunay_cell->info().region);
        is_infinite_.push_back(triangulation.is_infinite(delaunay_cell));
    }
    corners_.resize(count);
    neighbors_.resize(count);
    const auto connect = [&](std::size_t c)
    {
        for (int i = 0; c + kPrefetchDistance < cells_.size() && i < 4; ++i)
            __builtin_prefetch(&cells_[c + kPrefetchDistance]->neighbor(i)->info().scratch);
        corners_[c] = corner_indices(cells_[c]);
        for (int i = 0; i < 4; ++i)
            neighbors_[c][static_cast<std::size_t>(i)] = number(cells_[c]->neighbor(i));
    };
    workers.for_each(count, connect, kCellsAtOnce);
}

void CellTable::set_region(Number c, Region region)
{
    changes_.push_back({c, regions_[c]});
    regions_[c] = region;
    cells_[c]->info().region = region;
}

void CellTable::undo_changes_after(std::size_t count)
{
    for (; changes_.size() > count; changes_.pop_back())
    {
        const auto& [c, former] = changes_.back();
        regions_[c] = former;
        cells_[c]->info().region = former;
    }
}

void CellTable::give_back_regions()
{
    for (auto change = changes_.rbegin(); change != changes_.rend(); ++change)
        cells_[change->cell]->info().region = change->former;
}

std::optional<std::vector<CellTable::Number>> CellTable::update()
{
    const std::vector<DelaunayCell> made = take_new_cells();
    std::vector<Number> numbers = forget_gone_cells(made);
    if (numbers.size() > made.size())
        return std::nullopt;
    std::erase_if(changes_, [&](const Change& change) { return cells_[change.cell] == DelaunayCell(); });
    for (const auto& [c, former] : changes_)
        cells_[c]->info().region = regions_[c];
    make_room_for(cells_.size() + made.size() - numbers.size());
    while (numbers.size() < made.size())
    {
        numbers.push_back(size());
        cells_.emplace_back();
        neighbors_.emplace_back();
        corners_.emplace_back();
        is_infinite_.push_back(false);
        regions_.push_back(kOuterRegion);
    }
    for (std::size_t i = 0; i < made.size(); ++i)
        put(numbers[i], made[i]);
    CHECK_EQ(cells_.size(), triangulation_->tds().cells().size());
    for (const Number c : numbers)
    {
        for (int i = 0; i < 4; ++i)
        {
            const DelaunayCell next = cells_[c]->neighbor(i);
            neighbors_[c][static_cast<std::size_t>(i)] = number(next);
            neighbors_[number(next)][static_cast<std::size_t>(next->index(cells_[c]))] = c;
        }
    }
    return numbers;
}

//! Vectors that grow by themselves double: the table is large, and what insertions add to it is little.
void CellTable::make_room_for(std::size_t count)
{
    if (count <= cells_.capacity())
        return;
    const std::size_t room = count + count / kRoomShare;
    cells_.reserve(room);
    neighbors_.reserve(room);
    corners_.reserve(room);
    is_infinite_.reserve(room);
    regions_.reserve(room);
}

void CellTable::put(Number c, DelaunayCell delaunay_cell)
{
    delaunay_cell->info().scratch = c;
    cells_[c] = delaunay_cell;
    regions_[c] = delaunay_cell->info().region;
    corners_[c] = corner_indices(delaunay_cell);
    is_infinite_[c] = triangulation_->is_infinite(delaunay_cell);
}

//! The cells at vertices that came since; each is marked.
std::vector<DelaunayCell> CellTable::take_new_cells()
{
    std::vector<DelaunayCell> made;
    std::vector<DelaunayCell> star;
    for (const VertexHandle vertex : triangulation_->finite_vertex_handles())
    {
        if (vertex->info().index < vertices_seen_)
            continue;
        star.clear();
        triangulation_->incident_cells(vertex, std::back_inserter(star));
        for (const DelaunayCell delaunay_cell : star)
        {
            if (number(delaunay_cell) == kNewCell)
                continue;
            delaunay_cell->info().scratch = kNewCell;
            made.push_back(delaunay_cell);
        }
    }
    vertices_seen_ = triangulation_->number_of_vertices();
    return made;
}

bool CellTable::is_current(Number c) const
{
    return triangulation_->tds().cells().is_used(cells_[c]) && number(cells_[c]) == c;
}

//! The numbers of cells that are gone, which lose their handles: those that lay beyond facets of the new
//! cells, and from these on.
std::vector<CellTable::Number> CellTable::forget_gone_cells(const std::vector<DelaunayCell>& made)
{
    std::vector<Number> gone;
    const auto forget = [&](Number c)
    {
        if (cells_[c] == DelaunayCell() || is_current(c))
            return;
        cells_[c] = DelaunayCell();
        gone.push_back(c);
    };
    for (const DelaunayCell delaunay_cell : made)
    {
        for (int i = 0; i < 4; ++i)
        {
            const DelaunayCell next = delaunay_cell->neighbor(i);
            if (number(next) != kNewCell)
                forget(neighbors_[number(next)][static_cast<std::size_t>(next->index(delaunay_cell))]);
        }
    }
    for (std::size_t at = 0; at < gone.size(); ++at)
    {
        for (const Number next : neighbors_[gone[at]])
            forget(next);
    }
    return gone;
}

} // namespace voroprobe
