#include "mesher/relabelling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
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
    Relabelling(RestrictedDelaunay& restricted, const MeshingOptions& options)
        : restricted_(restricted), floor_(options.floor_radius),
          squared_sine_(std::pow(std::sin(options.min_facet_angle_deg * std::numbers::pi / 180.0), 2))
    {
    }

    std::size_t run()
    {
        std::vector<VertexHandle> pinched;
        for (const VertexHandle vertex : restricted_.triangulation().finite_vertex_handles())
        {
            if (vertex->info().pinched && vertex->info().origin != VertexOrigin::kSentinel)
                pinched.push_back(vertex);
        }
        // With an inventory, repair_regions() has dissolved them, and a single cell may stand for a speck.
        const bool inventory = restricted_.oracle().surface_count() > 0;
        std::size_t changed = inventory ? 0 : dissolve_crumbs(pinched);
        changed += sweep(pinched, Cells::kAgreeingWithOracle);
        changed += sweep(pinched, Cells::kAny);
        return changed;
    }

    std::vector<SideChange> run_for_angles()
    {
        std::vector<SideChange> changes;
        std::vector<DelaunayCell> candidates;
        for (const DelaunayCell delaunay_cell : restricted_.triangulation().finite_cell_handles())
            collect_beside_sharp_facets(delaunay_cell, candidates);
        for (int sweep = 0; sweep < kSweeps && !candidates.empty(); ++sweep)
        {
            std::vector<DelaunayCell> next;
            for (const DelaunayCell delaunay_cell : candidates)
            {
                if (!may_change(delaunay_cell) || !angles_gain_from_change(delaunay_cell))
                    continue;
                changes.push_back({delaunay_cell, delaunay_cell->info().region});
                change(delaunay_cell);
                collect_beside_sharp_facets(delaunay_cell, next);
            }
            candidates = std::move(next);
        }
        return changes;
    }

private:
    //! The cell and its neighbour at each of its facets in the mesh that is below the bound.
    void collect_beside_sharp_facets(DelaunayCell delaunay_cell, std::vector<DelaunayCell>& cells) const
    {
        for (int i = 0; i < 4; ++i)
        {
            if (!separates_sides(delaunay_cell, i) || !is_sharp(delaunay_cell, i))
                continue;
            cells.push_back(delaunay_cell);
            if (!restricted_.triangulation().is_infinite(delaunay_cell->neighbor(i)))
                cells.push_back(delaunay_cell->neighbor(i));
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

    static void change(DelaunayCell delaunay_cell)
    {
        delaunay_cell->info().region = *region_across(delaunay_cell);
        for (int i = 0; i < 4; ++i)
            delaunay_cell->vertex(i)->info().pinched = true; // as far as is known
    }

    //! Single cells, thinner than the floor, that are a piece (or a hole) by themselves and touch the rest at
    //! each corner.
    std::size_t dissolve_crumbs(const std::vector<VertexHandle>& pinched)
    {
        std::size_t changed = 0;
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
                if (!touches_everywhere)
                    continue;
                delaunay_cell->info().region = *region_across(delaunay_cell);
                ++changed;
            }
        }
        return changed;
    }

    //! Mends the given vertices, then those at the cells changed, and so on. Returns the number of cells
    //! changed.
    std::size_t sweep(std::vector<VertexHandle> vertices, Cells allowed)
    {
        std::size_t changed = 0;
        for (int sweep = 0; sweep < kSweeps && !vertices.empty(); ++sweep)
        {
            std::vector<VertexHandle> touched;
            for (const VertexHandle vertex : vertices)
            {
                const DelaunayCell delaunay_cell = mend(vertex, allowed);
                if (delaunay_cell == DelaunayCell())
                    continue;
                ++changed;
                for (int i = 0; i < 4; ++i)
                    touched.push_back(delaunay_cell->vertex(i));
            }
            const auto by_index = [](VertexHandle a, VertexHandle b)
            { return a->info().index < b->info().index; };
            std::sort(touched.begin(), touched.end(), by_index);
            touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
            vertices = std::move(touched);
        }
        return changed;
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

    RestrictedDelaunay& restricted_;
    double floor_;
    double squared_sine_;
    std::vector<DelaunayCell> cells_;
    std::vector<DelaunayCell> star_;
};

} // namespace

std::size_t relabel_pinched_cells(RestrictedDelaunay& restricted, const MeshingOptions& options)
{
    return Relabelling(restricted, options).run();
}

std::vector<SideChange> relabel_sharp_cells(RestrictedDelaunay& restricted, const MeshingOptions& options)
{
    return Relabelling(restricted, options).run_for_angles();
}

} // namespace voroprobe
