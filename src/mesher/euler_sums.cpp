#include "mesher/euler_sums.h"

#include <algorithm>
#include <iterator>

#include "mesher/boundary_complex.h"
#include "mesher/edge_turn.h"
#include "support/check.h"
#include "support/union_find.h"

namespace voroprobe
{
namespace
{

SurfaceId surface_of(const SurfaceOracle& oracle, DelaunayCell delaunay_cell, int index)
{
    return oracle.surface_between(delaunay_cell->info().region,
                                  delaunay_cell->neighbor(index)->info().region);
}

//! The odd facets at a vertex, paired across the edges there as collect_boundary() pairs them.
class VertexStar
{
public:
    VertexStar(const RestrictedDelaunay& restricted, VertexHandle vertex)
        : restricted_(restricted), vertex_(vertex)
    {
        std::vector<DelaunayCell> star;
        restricted.triangulation().incident_cells(vertex, std::back_inserter(star));
        for (const DelaunayCell delaunay_cell : star)
        {
            for (int i = 0; i < 4; ++i)
            {
                if (inside(delaunay_cell) && delaunay_cell->vertex(i) != vertex &&
                    separates_sides(delaunay_cell, i))
                    facets_.push_back({delaunay_cell, i});
            }
        }
    }

    //! Adds two for each umbrella of a surface.
    void add_umbrellas(DoubledEuler& sums) const
    {
        UnionFind umbrellas = find_umbrellas();
        for (std::uint32_t f = 0; f < facets_.size(); ++f)
        {
            if (umbrellas.find(f) == f)
                sums[surface_of(restricted_.oracle(), facets_[f].delaunay_cell, facets_[f].index)] += 2;
        }
    }

private:
    [[nodiscard]] UnionFind find_umbrellas() const
    {
        UnionFind umbrellas(facets_.size());
        if (join_at_edges_of_two(umbrellas))
            return umbrellas;
        umbrellas = UnionFind(facets_.size());
        join_across_edges(umbrellas);
        return umbrellas;
    }

    //! Joins the two facets at each edge; false where an edge has more, and it takes more to tell which.
    bool join_at_edges_of_two(UnionFind& umbrellas) const
    {
        struct Edge
        {
            VertexHandle other;
            std::uint32_t facet;
            int count;
        };
        std::vector<Edge> edges;
        for (std::uint32_t f = 0; f < facets_.size(); ++f)
        {
            for (int k = 0; k < 4; ++k)
            {
                const VertexHandle other = facets_[f].delaunay_cell->vertex(k);
                if (k == facets_[f].index || other == vertex_)
                    continue;
                const auto edge = std::find_if(edges.begin(), edges.end(),
                                               [&](const Edge& each) { return each.other == other; });
                if (edge == edges.end())
                    edges.push_back({other, f, 1});
                else if (++edge->count > 2)
                    return false;
                else
                    umbrellas.unite(edge->facet, f);
            }
        }
        return true;
    }

    void join_across_edges(UnionFind& umbrellas) const
    {
        for (std::uint32_t f = 0; f < facets_.size(); ++f)
        {
            for (int k = 0; k < 4; ++k)
            {
                const VertexHandle other = facets_[f].delaunay_cell->vertex(k);
                if (k != facets_[f].index && other != vertex_)
                    umbrellas.unite(f, number(partner_across(facets_[f], other)));
            }
        }
    }

    [[nodiscard]] FacetOfCell partner_across(const FacetOfCell& facet, VertexHandle other) const
    {
        const FacetOfCell through_inside = next_odd_facet(facet.delaunay_cell, facet.index, vertex_, other);
        const DelaunayCell outside = facet.delaunay_cell->neighbor(facet.index);
        const FacetOfCell beyond =
            next_odd_facet(outside, outside->index(facet.delaunay_cell), vertex_, other);
        const DelaunayCell next = beyond.delaunay_cell->neighbor(beyond.index);
        const FacetOfCell through_outside{next, next->index(beyond.delaunay_cell)};
        if (is_same(through_inside, through_outside) ||
            !joined_at_edge(restricted_, facet.delaunay_cell, vertex_, other))
            return through_inside;
        return through_outside;
    }

    static bool is_same(const FacetOfCell& a, const FacetOfCell& b)
    {
        return a.delaunay_cell == b.delaunay_cell && a.index == b.index;
    }

    [[nodiscard]] std::uint32_t number(const FacetOfCell& facet) const
    {
        const auto found = std::find_if(facets_.begin(), facets_.end(),
                                        [&](const FacetOfCell& other) { return is_same(facet, other); });
        CHECK(found != facets_.end());
        return static_cast<std::uint32_t>(found - facets_.begin());
    }

    const RestrictedDelaunay& restricted_;
    VertexHandle vertex_;
    std::vector<FacetOfCell> facets_; //!< each from its inside cell
};

bool by_index(VertexHandle a, VertexHandle b)
{
    return a->info().index < b->info().index;
}

std::vector<VertexHandle> corners_of(const std::vector<DelaunayCell>& delaunay_cells)
{
    std::vector<VertexHandle> corners;
    for (const DelaunayCell delaunay_cell : delaunay_cells)
        for (int i = 0; i < 4; ++i)
            corners.push_back(delaunay_cell->vertex(i));
    std::sort(corners.begin(), corners.end(), by_index);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

std::vector<Point3> positions_by_index(const RestrictedDelaunay& restricted)
{
    std::vector<Point3> positions(restricted.vertex_index_bound());
    for (const VertexHandle vertex : restricted.triangulation().finite_vertex_handles())
        positions[vertex->info().index] = position(vertex);
    return positions;
}

} // namespace

DoubledEuler doubled_euler_around(const RestrictedDelaunay& restricted,
                                  const std::vector<DelaunayCell>& delaunay_cells)
{
    DoubledEuler sums;
    for (auto at = delaunay_cells.begin(); at != delaunay_cells.end(); ++at)
    {
        for (int i = 0; i < 4; ++i)
        {
            // A facet between two of the cells is met from both; the first one counts it.
            const bool counted = std::find(delaunay_cells.begin(), at, (*at)->neighbor(i)) != at;
            if (separates_sides(*at, i) && !counted)
                --sums[surface_of(restricted.oracle(), *at, i)];
        }
    }
    for (const VertexHandle vertex : corners_of(delaunay_cells))
        VertexStar(restricted, vertex).add_umbrellas(sums);
    return sums;
}

MeshedSurfaces find_meshed_surfaces(const RestrictedDelaunay& restricted, const CellTable& table)
{
    const SurfaceOracle& oracle = restricted.oracle();
    MeshedSurfaces found{std::vector<long>(oracle.surface_count(), 0), {}};
    std::vector<SurfaceId> surface_of_vertex(restricted.vertex_index_bound(), kNoSurface); // one of its own
    const std::vector<Point3> positions = positions_by_index(restricted);
    double squared_longest_side = 0.0;
    for (CellTable::Number c = 0; c < table.size(); ++c)
    {
        for (std::size_t i = 0; is_inside(table.region(c)) && i < 4; ++i)
        {
            const Region beyond = table.region(table.neighbors(c)[i]);
            const SurfaceId surface =
                is_inside(beyond) ? kNoSurface : oracle.surface_between(table.region(c), beyond);
            if (surface == kNoSurface)
                continue;
            --found.doubled_euler[static_cast<std::size_t>(surface)];
            for (std::size_t k = 1; k < 4; ++k)
            {
                const std::uint32_t corner = table.corners(c)[(i + k) % 4];
                const std::uint32_t next = table.corners(c)[(i + k % 3 + 1) % 4];
                surface_of_vertex[corner] = surface;
                squared_longest_side =
                    std::max(squared_longest_side, squared_distance(positions[corner], positions[next]));
            }
        }
    }
    found.longest_side = std::sqrt(squared_longest_side);
    for (const VertexHandle vertex : restricted.triangulation().finite_vertex_handles())
    {
        const SurfaceId surface = surface_of_vertex[vertex->info().index];
        if (surface == kNoSurface)
            continue;
        const auto add = [&](SurfaceId at, long sum)
        {
            found.doubled_euler[static_cast<std::size_t>(at)] += sum;
            found.vertices.push_back({at, position(vertex)});
        };
        if (!vertex->info().pinched)
        {
            add(surface, 2);
            continue;
        }
        DoubledEuler umbrellas;
        VertexStar(restricted, vertex).add_umbrellas(umbrellas);
        umbrellas.erase(kNoSurface);
        for (const auto& [each, sum] : umbrellas)
            add(each, sum);
    }
    return found;
}

} // namespace voroprobe
