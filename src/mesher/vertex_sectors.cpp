#include "mesher/vertex_sectors.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "support/union_find.h"

namespace voroprobe
{
namespace
{

//! The Delaunay cells around a vertex, joined into parts of space.
class Sectors
{
public:
    Sectors(const Triangulation& triangulation, VertexHandle vertex)
        : cells_(incident_cells(triangulation, vertex)), parts_(cells_.size())
    {
        for (std::uint32_t c = 0; c < cells_.size(); ++c)
        {
            for (int i = 0; i < 4; ++i)
            {
                const DelaunayCell neighbor = cells_[c]->neighbor(i);
                if (cells_[c]->vertex(i) != vertex && inside(neighbor) == inside(cells_[c]))
                    parts_.unite(c, number(neighbor));
            }
        }
    }

    //! Makes the inside (outside) cells around the edge to `other` one part.
    void join_at_edge(VertexHandle other, bool inner)
    {
        auto first = static_cast<std::uint32_t>(cells_.size());
        for (std::uint32_t c = 0; c < cells_.size(); ++c)
        {
            if (inside(cells_[c]) != inner || !cells_[c]->has_vertex(other))
                continue;
            if (first == cells_.size())
                first = c;
            parts_.unite(first, c);
        }
    }

    [[nodiscard]] DelaunayCell cell_with_edge_to(VertexHandle other) const
    {
        return *std::find_if(cells_.begin(), cells_.end(),
                             [&](DelaunayCell delaunay_cell) { return delaunay_cell->has_vertex(other); });
    }

    std::uint32_t part(DelaunayCell delaunay_cell) { return parts_.find(number(delaunay_cell)); }

private:
    static std::vector<DelaunayCell> incident_cells(const Triangulation& triangulation, VertexHandle vertex)
    {
        std::vector<DelaunayCell> cells;
        triangulation.incident_cells(vertex, std::back_inserter(cells));
        return cells;
    }

    [[nodiscard]] std::uint32_t number(DelaunayCell delaunay_cell) const
    {
        return static_cast<std::uint32_t>(std::find(cells_.begin(), cells_.end(), delaunay_cell) -
                                          cells_.begin());
    }

    std::vector<DelaunayCell> cells_;
    UnionFind parts_;
};

//! The vertices with more than two odd facets on their edge to `vertex`.
std::vector<VertexHandle> pinched_neighbors(VertexHandle vertex, const std::vector<BoundaryFace>& faces)
{
    std::map<std::uint32_t, std::pair<VertexHandle, int>> facets_on_edge;
    for (const BoundaryFace& face : faces)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            const VertexHandle other = corner(face, k);
            if (other == vertex)
                continue;
            auto& entry = facets_on_edge[other->info().index];
            entry.first = other;
            ++entry.second;
        }
    }
    std::vector<VertexHandle> pinched;
    for (const auto& [index, entry] : facets_on_edge)
    {
        if (entry.second > 2)
            pinched.push_back(entry.first);
    }
    return pinched;
}

} // namespace

std::vector<UmbrellaSides> find_umbrella_sides(const RestrictedDelaunay& restricted, VertexHandle vertex,
                                               const std::vector<BoundaryFace>& faces,
                                               const std::vector<std::uint32_t>& copies)
{
    Sectors sectors(restricted.triangulation(), vertex);
    for (const VertexHandle other : pinched_neighbors(vertex, faces))
        sectors.join_at_edge(other,
                             joined_at_edge(restricted, sectors.cell_with_edge_to(other), vertex, other));

    // All faces of an umbrella see the same part on either side: one of them speaks for it.
    struct Parts
    {
        std::uint32_t inner;
        std::uint32_t outer;
    };
    std::map<std::uint32_t, Parts> parts_of_copy;
    for (std::size_t f = 0; f < faces.size(); ++f)
        parts_of_copy[copies[f]] = {sectors.part(faces[f].inside),
                                    sectors.part(faces[f].inside->neighbor(faces[f].index))};

    std::vector<UmbrellaSides> sides;
    for (const auto& [copy, parts] : parts_of_copy)
    {
        UmbrellaSides side{copy, true, true};
        for (const auto& [other_copy, other_parts] : parts_of_copy)
        {
            if (other_copy == copy)
                continue;
            side.owns_inside = side.owns_inside && other_parts.inner != parts.inner;
            side.owns_outside = side.owns_outside && other_parts.outer != parts.outer;
        }
        sides.push_back(side);
    }
    return sides;
}

} // namespace voroprobe
