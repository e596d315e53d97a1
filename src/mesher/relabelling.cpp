#include "mesher/relabelling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mesher/boundary_complex.h"
#include "mesher/cell_shape.h"
#include "support/union_find.h"

namespace voroprobe
{
namespace
{

// What a defect costs, in faces below the angle bound: an edge left pinched is cut in the middle, which
// leaves four such faces; it is counted at both its ends.
constexpr int kCostOfPinchedEdgeEnd = 2;
constexpr int kCostOfUmbrella = 1;
constexpr int kSweeps = 8; // each sees what the one before has changed

int count_odd_facets(DelaunayCell delaunay_cell)
{
    int count = 0;
    for (int i = 0; i < 4; ++i)
        count += separates_sides(delaunay_cell, i) ? 1 : 0;
    return count;
}

//! The region on the other side of a cell's odd facets; nullopt where a third region touches the cell.
std::optional<Region> region_across(DelaunayCell delaunay_cell)
{
    const Region own = delaunay_cell->info().region;
    std::optional<Region> across;
    for (int i = 0; i < 4; ++i)
    {
        const Region next = delaunay_cell->neighbor(i)->info().region;
        if (next == own)
            continue;
        if (is_inside(next) == is_inside(own) || (across && *across != next))
            return std::nullopt;
        across = next;
    }
    return across;
}

//! Which cells at a pinched edge may change sides.
enum class Cells
{
    kAgreeingWithOracle, //!< those on the side where the middle of the edge is not
    kAny
};

//! The odd facets around one vertex as edges of its link.
struct Link
{
    std::vector<VertexHandle> nodes;
    std::vector<int> degrees;
    std::size_t component_count = 0;
};

//! What is wrong around a cell, in faces below the angle bound.
struct Cost
{
    int pinches = 0;         //!< pinched edges, and umbrellas of vertices
    int sharp_facets = 0;    //!< below the bound
    bool is_manifold = true; //!< no edge is pinched, no vertex has several umbrellas

    [[nodiscard]] int sum() const { return pinches + sharp_facets; }
};

class Relabelling
{
public:
    Relabelling(const RestrictedDelaunay& restricted, CellTable& table, const MeshingOptions& options)
        : restricted_(restricted), table_(table), floor_(options.floor_radius),
          squared_sine_(std::pow(std::sin(options.min_facet_angle_deg * std::numbers::pi / 180.0), 2))
    {
    }

    std::size_t run(std::vector<VertexHandle> vertices)
    {
        // With an inventory, repair_regions() has dissolved them, and a single cell may stand for a speck.
        if (restricted_.oracle().surface_count() == 0)
            dissolve_crumbs(vertices);
        std::erase_if(vertices, [&](VertexHandle vertex) { return !has_pinched_edge(vertex); });
        sweep(vertices, Cells::kAgreeingWithOracle);
        for (const CellTable::Change& change : changes())
            add_corners(table_.cell(change.cell), vertices);
        sort_by_index(vertices);
        sweep(vertices, Cells::kAny);
        return changes().size();
    }

    std::size_t run_for_angles()
    {
        std::vector<DelaunayCell> candidates;
        for (CellTable::Number c = 0; c < table_.size(); ++c)
        {
            if (!table_.is_infinite(c))
                collect_beside_sharp_facets(c, candidates);
        }
        for (int sweep = 0; sweep < kSweeps && !candidates.empty(); ++sweep)
        {
            std::vector<DelaunayCell> next;
            for (const DelaunayCell delaunay_cell : candidates)
            {
                if (!may_change(delaunay_cell) || !angles_gain_from_change(delaunay_cell))
                    continue;
                change(delaunay_cell);
                collect_beside_sharp_facets(CellTable::number(delaunay_cell), next);
            }
            candidates = std::move(next);
        }
        return changes().size();
    }

private:
    //! The cell and its neighbour at each of its facets in the mesh that is below the bound.
    void collect_beside_sharp_facets(CellTable::Number cell, std::vector<DelaunayCell>& cells) const
    {
        for (std::size_t i = 0; i < 4; ++i)
        {
            const CellTable::Number next = table_.neighbors(cell)[i];
            if (is_inside(table_.region(cell)) == is_inside(table_.region(next)) ||
                !is_sharp(table_.cell(cell), static_cast<int>(i)))
                continue;
            cells.push_back(table_.cell(cell));
            if (!table_.is_infinite(next))
                cells.push_back(table_.cell(next));
        }
    }

    [[nodiscard]] bool is_sharp(DelaunayCell delaunay_cell, int i) const
    {
        return below_bound(position(delaunay_cell->vertex((i + 1) % 4)),
                           position(delaunay_cell->vertex((i + 2) % 4)),
                           position(delaunay_cell->vertex((i + 3) % 4)));
    }

    //! Whether fewer facets of the cell are below the bound then, and nothing is pinched before and after.
    bool angles_gain_from_change(DelaunayCell delaunay_cell)
    {
        const Cost before = cost_around(delaunay_cell);
        const Region own = std::exchange(delaunay_cell->info().region, *region_across(delaunay_cell));
        const Cost after = cost_around(delaunay_cell);
        delaunay_cell->info().region = own;
        return after.sharp_facets < before.sharp_facets && before.is_manifold && after.is_manifold;
    }

    void change(DelaunayCell delaunay_cell)
    {
        table_.set_region(CellTable::number(delaunay_cell), *region_across(delaunay_cell));
        for (int i = 0; i < 4; ++i)
            delaunay_cell->vertex(i)->info().pinched = true; // as far as is known
    }

    //! Those made by this object.
    [[nodiscard]] std::span<const CellTable::Change> changes() const
    {
        return std::span(table_.changes()).subspan(first_change_);
    }

    static void add_corners(DelaunayCell delaunay_cell, std::vector<VertexHandle>& vertices)
    {
        for (int i = 0; i < 4; ++i)
            vertices.push_back(delaunay_cell->vertex(i));
    }

    static void sort_by_index(std::vector<VertexHandle>& vertices)
    {
        std::sort(vertices.begin(), vertices.end(),
                  [](VertexHandle a, VertexHandle b) { return a->info().index < b->info().index; });
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }

    //! Sets VertexData::pinched.
    bool has_pinched_edge(VertexHandle vertex)
    {
        const Link link = link_of(vertex);
        const bool pinched =
            std::any_of(link.degrees.begin(), link.degrees.end(), [](int degree) { return degree > 2; });
        vertex->info().pinched = pinched || link.component_count != 1;
        return pinched;
    }

    //! Single cells, thinner than the floor, that are a piece (or a hole) by themselves and touch the rest at
    //! each corner.
    void dissolve_crumbs(const std::vector<VertexHandle>& pinched)
    {
        for (const VertexHandle vertex : pinched)
        {
            for (const DelaunayCell delaunay_cell : cells_around(vertex))
            {
                if (count_odd_facets(delaunay_cell) != 4 || !region_across(delaunay_cell) ||
                    least_altitude(corner_positions(delaunay_cell)) > floor_)
                    continue;
                bool touches_everywhere = true;
                for (int i = 0; i < 4 && touches_everywhere; ++i)
                    touches_everywhere = link_of(delaunay_cell->vertex(i)).nodes.size() > 3;
                if (touches_everywhere)
                    change(delaunay_cell);
            }
        }
    }

    //! Mends the given vertices, then those at the cells changed, and so on.
    void sweep(std::vector<VertexHandle> vertices, Cells allowed)
    {
        for (int sweep = 0; sweep < kSweeps && !vertices.empty(); ++sweep)
        {
            std::vector<VertexHandle> touched;
            for (const VertexHandle vertex : vertices)
            {
                const DelaunayCell delaunay_cell = mend(vertex, allowed);
                if (delaunay_cell != DelaunayCell())
                    add_corners(delaunay_cell, touched);
            }
            sort_by_index(touched);
            vertices = std::move(touched);
        }
    }

    //! Changes the side of the cell at the vertex that gains most, and returns it; a null handle where none
    //! gains.
    DelaunayCell mend(VertexHandle vertex, Cells allowed)
    {
        const Link link = link_of(vertex);
        std::optional<std::pair<int, DelaunayCell>> best;
        for (std::size_t n = 0; n < link.nodes.size(); ++n)
        {
            if (link.degrees[n] <= 2)
                continue;
            const auto& around = cells_around(vertex);
            const auto with_edge = std::find_if(around.begin(), around.end(),
                                                [&](DelaunayCell delaunay_cell)
                                                { return delaunay_cell->has_vertex(link.nodes[n]); });
            const bool joined = joined_at_edge(restricted_, *with_edge, vertex, link.nodes[n]);
            for (const DelaunayCell delaunay_cell : cells_around(vertex))
            {
                if (!delaunay_cell->has_vertex(link.nodes[n]) ||
                    (allowed == Cells::kAgreeingWithOracle && inside(delaunay_cell) == joined) ||
                    !may_change(delaunay_cell))
                    continue;
                const int gain = gain_of_change(delaunay_cell);
                if (gain > 0 && (!best || gain > best->first))
                    best = {gain, delaunay_cell};
            }
        }
        if (!best)
            return {};
        change(best->second);
        return best->second;
    }

    //! Two odd facets change places with the other two, three with one; one would make way for three.
    [[nodiscard]] bool may_change(DelaunayCell delaunay_cell) const
    {
        const int odd_count = count_odd_facets(delaunay_cell);
        return (odd_count == 2 || odd_count == 3) && region_across(delaunay_cell) &&
               least_altitude(corner_positions(delaunay_cell)) <= floor_;
    }

    int gain_of_change(DelaunayCell delaunay_cell)
    {
        const int before = cost_around(delaunay_cell).sum();
        const Region own = std::exchange(delaunay_cell->info().region, *region_across(delaunay_cell));
        const int after = cost_around(delaunay_cell).sum();
        delaunay_cell->info().region = own;
        return before - after;
    }

    //! Everything that depends on the side of a cell: the links of its vertices and its own facets.
    Cost cost_around(DelaunayCell delaunay_cell)
    {
        Cost cost;
        for (int i = 0; i < 4; ++i)
        {
            const Link link = link_of(delaunay_cell->vertex(i));
            for (const int degree : link.degrees)
            {
                cost.pinches += degree > 2 ? kCostOfPinchedEdgeEnd * (degree / 2 - 1) : 0;
                cost.is_manifold = cost.is_manifold && degree == 2;
            }
            cost.pinches += kCostOfUmbrella * static_cast<int>(link.component_count);
            cost.is_manifold = cost.is_manifold && link.component_count <= 1;
            if (separates_sides(delaunay_cell, i) && is_sharp(delaunay_cell, i))
                ++cost.sharp_facets;
        }
        return cost;
    }

    [[nodiscard]] bool below_bound(const Point3& a, const Point3& b, const Point3& c) const
    {
        const double aa = squared_distance(b, c);
        const double bb = squared_distance(c, a);
        const double cc = squared_distance(a, b);
        const double four_squared_areas = squared_norm(cross(b - a, c - a));
        return std::min({aa, bb, cc}) * four_squared_areas < aa * bb * cc * squared_sine_;
    }

    const std::vector<DelaunayCell>& cells_around(VertexHandle vertex)
    {
        cells_.clear();
        restricted_.triangulation().incident_cells(vertex, std::back_inserter(cells_));
        return cells_;
    }

    Link link_of(VertexHandle vertex)
    {
        Link link;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
        star_.clear();
        restricted_.triangulation().incident_cells(vertex, std::back_inserter(star_));
        for (const DelaunayCell delaunay_cell : star_)
        {
            for (int i = 0; i < 4; ++i)
            {
                if (!inside(delaunay_cell) || delaunay_cell->vertex(i) == vertex ||
                    !separates_sides(delaunay_cell, i))
                    continue;
                const int apex = delaunay_cell->index(vertex);
                const int a = i != 0 && apex != 0 ? 0 : i != 1 && apex != 1 ? 1 : 2;
                const int b = 6 - apex - i - a;
                const std::uint32_t first = node(link, delaunay_cell->vertex(a));
                const std::uint32_t second = node(link, delaunay_cell->vertex(b));
                edges.emplace_back(first, second);
            }
        }
        link.degrees.assign(link.nodes.size(), 0);
        link.component_count = link.nodes.size();
        UnionFind components(link.nodes.size());
        for (const auto& [a, b] : edges)
        {
            ++link.degrees[a];
            ++link.degrees[b];
            if (components.find(a) != components.find(b))
                --link.component_count;
            components.unite(a, b);
        }
        return link;
    }

    static std::uint32_t node(Link& link, VertexHandle vertex)
    {
        const auto number = std::find(link.nodes.begin(), link.nodes.end(), vertex) - link.nodes.begin();
        if (static_cast<std::size_t>(number) == link.nodes.size())
            link.nodes.push_back(vertex);
        return static_cast<std::uint32_t>(number);
    }

    const RestrictedDelaunay& restricted_;
    CellTable& table_;
    double floor_;
    double squared_sine_;
    std::size_t first_change_ = table_.changes().size();
    std::vector<DelaunayCell> cells_;
    std::vector<DelaunayCell> star_;
};

} // namespace

std::size_t relabel_pinched_cells(const RestrictedDelaunay& restricted, CellTable& table,
                                  const MeshingOptions& options, std::vector<VertexHandle> vertices)
{
    return Relabelling(restricted, table, options).run(std::move(vertices));
}

std::size_t relabel_sharp_cells(const RestrictedDelaunay& restricted, CellTable& table,
                                const MeshingOptions& options)
{
    return Relabelling(restricted, table, options).run_for_angles();
}

} // namespace voroprobe
