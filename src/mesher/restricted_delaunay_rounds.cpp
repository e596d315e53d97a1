// Insertions side by side: what is handed out before a round, and made one thing after it.

#include "mesher/restricted_delaunay.h"

#include <algorithm>
#include <vector>

namespace voroprobe
{
namespace
{

// An insertion adds seven Delaunay cells and two or three restricted facets on average, many more at times.
constexpr std::size_t kCellsInStockPerInsertion = 12;
constexpr std::size_t kFacetsInStockPerInsertion = 6;

// Moves the elements of one list to the end of another.
template <typename T>
void append(std::vector<T>& from, std::vector<T>& to)
{
    to.insert(to.end(), from.begin(), from.end());
    from.clear();
}

} // namespace

void RestrictedDelaunay::begin_round(std::span<InsertionWorkspace* const> workspaces, std::size_t insertions)
{
    for (std::size_t w = 0; w < workspaces.size(); ++w)
    {
        fill_stock(*workspaces[w], insertions);
        workspaces[w]->stock.first_index = vertex_index_bound_ + static_cast<std::uint32_t>(w * insertions);
    }
}

void RestrictedDelaunay::fill_stock(InsertionWorkspace& workspace, std::size_t insertions)
{
    InsertionWorkspace::Stock& stock = workspace.stock;
    workspace.has_stock = true;
    while (stock.cells.size() < insertions * kCellsInStockPerInsertion)
        stock.cells.push_back(triangulation_.tds().create_cell());
    while (stock.vertices.size() < insertions)
        stock.vertices.push_back(triangulation_.tds().create_vertex());
    while (workspace.free_facets.size() < insertions * kFacetsInStockPerInsertion)
        workspace.free_facets.push_back(allocate_facet(workspace_));
    stock.new_vertices.clear();
    stock.new_facets.clear();
    stock.cell_of_sentinel.fill({});
}

bool RestrictedDelaunay::has_enough(const InsertionWorkspace& workspace, const Insertion& insertion)
{
    const InsertionWorkspace::Stock& stock = workspace.stock;
    return !stock.vertices.empty() &&
           stock.cells.size() + insertion.zone().cells().size() >= insertion.star().size() &&
           workspace.free_facets.size() >= insertion.new_facets().size();
}

void RestrictedDelaunay::end_round(std::span<InsertionWorkspace* const> workspaces, const Workers& workers)
{
    std::vector<std::uint32_t> shifts;
    for (const InsertionWorkspace* const workspace : workspaces)
    {
        shifts.push_back(workspace->stock.first_index - vertex_index_bound_);
        vertex_index_bound_ += static_cast<std::uint32_t>(workspace->stock.new_vertices.size());
    }
    workers.for_each(
        workspaces.size(), [&](std::size_t w) { close_ranks(workspaces[w]->stock, shifts[w]); }, 1);
    for (InsertionWorkspace* const workspace : workspaces)
    {
        for (const DelaunayCell at_sentinel : workspace->stock.cell_of_sentinel)
        {
            for (int i = 0; at_sentinel != DelaunayCell() && i < 4; ++i)
            {
                if (at_sentinel->vertex(i)->info().origin == VertexOrigin::kSentinel)
                    at_sentinel->vertex(i)->set_cell(at_sentinel);
            }
        }
        append(workspace->unchecked_vertices, workspace_.unchecked_vertices);
        append(workspace->unprobed_vertices, workspace_.unprobed_vertices);
        append(workspace->postponed_cells, workspace_.postponed_cells);
        count(*workspace);
    }
    forget_dead_postponed_cells();
}

// Indices of vertices follow each other: those of one subdomain are moved down to those of the one before.
void RestrictedDelaunay::close_ranks(InsertionWorkspace::Stock& stock, std::uint32_t shift)
{
    if (shift == 0)
        return;
    for (const VertexHandle vertex : stock.new_vertices)
        vertex->info().index -= shift;
    std::sort(stock.new_facets.begin(), stock.new_facets.end());
    stock.new_facets.erase(std::unique(stock.new_facets.begin(), stock.new_facets.end()),
                           stock.new_facets.end());
    for (const FacetId id : stock.new_facets)
    {
        for (std::uint32_t& vertex : facets_[id].vertices)
            vertex -= vertex >= stock.first_index ? shift : 0;
    }
}

void RestrictedDelaunay::take_back(InsertionWorkspace& workspace)
{
    for (const DelaunayCell delaunay_cell : workspace.stock.cells)
        triangulation_.tds().delete_cell(delaunay_cell);
    for (const VertexHandle vertex : workspace.stock.vertices)
        triangulation_.tds().delete_vertex(vertex);
    append(workspace.free_facets, workspace_.free_facets);
    workspace = {};
}

} // namespace voroprobe
