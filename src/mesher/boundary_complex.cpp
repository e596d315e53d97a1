#include "mesher/boundary_complex.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "mesher/edge_turn.h"
#include "support/check.h"
#include "support/union_find.h"

namespace voroprobe
{
namespace
{

constexpr auto kUnnumbered = std::numeric_limits<std::uint32_t>::max();

//! The half-edge, or corner, that follows in the same face.
std::uint32_t next_in_face(std::uint32_t half_edge)
{
    return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}

//! The vertices of the triangulation by their indices.
struct VertexTable
{
    explicit VertexTable(const RestrictedDelaunay& restricted)
        : handle(restricted.vertex_index_bound()), pinched(restricted.vertex_index_bound(), 0)
    {
        for (const VertexHandle vertex : restricted.triangulation().finite_vertex_handles())
        {
            handle[vertex->info().index] = vertex;
            pinched[vertex->info().index] = vertex->info().pinched ? 1 : 0;
        }
    }

    std::vector<VertexHandle> handle;
    std::vector<std::uint8_t> pinched;
};

//! Boundary faces with the indices of their corners, in the order of corner(), and those of them with a
//! pinched one: what is special about the others need not be looked for.
struct FoundFaces
{
    std::vector<BoundaryFace> faces;
    std::vector<std::array<std::uint32_t, 3>> corners;
    std::vector<std::uint32_t> pinched; //!< in their order
};

FoundFaces find_faces(const CellTable& table, const VertexTable& vertices)
{
    FoundFaces found;
    found.faces.reserve(2 * vertices.handle.size()); // of closed surfaces with few handles
    found.corners.reserve(2 * vertices.handle.size());
    for (CellTable::Number c = 0; c < table.size(); ++c)
    {
        if (!is_inside(table.region(c))) // infinite cells are outside
            continue;
        for (std::size_t i = 0; i < 4; ++i)
        {
            if (is_inside(table.region(table.neighbors(c)[i])))
                continue;
            std::array<std::uint32_t, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = table.corners(c)[static_cast<std::size_t>(kOutwardCorners[i][k])];
            if (std::any_of(corners.begin(), corners.end(),
                            [&](std::uint32_t corner) { return vertices.pinched[corner] != 0; }))
                found.pinched.push_back(static_cast<std::uint32_t>(found.faces.size()));
            found.faces.push_back({table.cell(c), static_cast<int>(i)});
            found.corners.push_back(corners);
        }
    }
    return found;
}

//! The table of facets has served: from here on both sides of the facets name their faces.
void name_pinched_faces(const FoundFaces& found)
{
    for (const std::uint32_t f : found.pinched)
    {
        const auto& [inner, index] = found.faces[f];
        const DelaunayCell outer = inner->neighbor(index);
        inner->info().facet[static_cast<std::size_t>(index)] = f;
        outer->info().facet[static_cast<std::size_t>(outer->index(inner))] = f;
    }
}

//! The face of the odd facet that next_odd_facet() finds.
std::uint32_t next_face(DelaunayCell start, int entered_at, VertexHandle a, VertexHandle b)
{
    const FacetOfCell next = next_odd_facet(start, entered_at, a, b);
    return next.delaunay_cell->info().facet[static_cast<std::size_t>(next.index)];
}

//! Pairs odd facets across the edges they share. Where more than two share one, the surface pinches itself
//! there: the inside parts are one where the middle of the edge is inside, and apart where it is outside.
class EdgePairing
{
public:
    explicit EdgePairing(const RestrictedDelaunay& restricted) : restricted_(restricted) {}

    [[nodiscard]] std::uint32_t partner_across(const BoundaryFace& face, VertexHandle a, VertexHandle b) const
    {
        const std::uint32_t through_inside = next_face(face.inside, face.index, a, b);
        if (!a->info().pinched || !b->info().pinched)
            return through_inside;
        const DelaunayCell outside = face.inside->neighbor(face.index);
        const std::uint32_t through_outside = next_face(outside, outside->index(face.inside), a, b);
        if (through_inside == through_outside)
            return through_inside;
        return joined_at_edge(restricted_, face.inside, a, b) ? through_outside : through_inside;
    }

private:
    const RestrictedDelaunay& restricted_;
};

std::uint32_t corner_number(const std::vector<BoundaryFace>& faces, std::uint32_t face, VertexHandle vertex)
{
    for (std::uint32_t k = 0; k < 3; ++k)
    {
        if (corner(faces[face], k) == vertex)
            return 3 * face + k;
    }
    CHECK(false && "the partner across an edge has the edge's ends");
    return 0;
}

//! The partner of each half-edge with an end at a pinched vertex; kUnnumbered for the others, whose edge has
//! two faces only.
std::vector<std::uint32_t> pair_half_edges(const RestrictedDelaunay& restricted, const FoundFaces& found)
{
    std::vector<std::uint32_t> partners(3 * found.faces.size(), kUnnumbered);
    const EdgePairing pairing(restricted);
    for (const std::uint32_t f : found.pinched)
    {
        const BoundaryFace& face = found.faces[f];
        for (std::uint32_t half_edge = 3 * f; half_edge < 3 * f + 3; ++half_edge)
        {
            if (partners[half_edge] != kUnnumbered)
                continue; // the partner's partner
            const VertexHandle a = corner(face, half_edge % 3);
            const VertexHandle b = corner(face, next_in_face(half_edge) % 3);
            if (!a->info().pinched && !b->info().pinched)
                continue;
            const std::uint32_t partner =
                corner_number(found.faces, pairing.partner_across(face, a, b), b); // runs from b to a
            partners[half_edge] = partner;
            partners[partner] = half_edge;
        }
    }
    return partners;
}

//! Corner k of face f, 3 f + k, counted among those of the faces with a pinched one.
std::uint32_t among_pinched(const FoundFaces& found, std::uint32_t corner)
{
    const auto face = std::lower_bound(found.pinched.begin(), found.pinched.end(), corner / 3);
    return static_cast<std::uint32_t>(3 * (face - found.pinched.begin())) + corner % 3;
}

//! Corners of the faces with a pinched one, joined across paired edges.
UnionFind join_corners(const FoundFaces& found, const std::vector<std::uint32_t>& partners)
{
    UnionFind corners(3 * found.pinched.size());
    const auto unite = [&](std::uint32_t a, std::uint32_t b)
    { corners.unite(among_pinched(found, a), among_pinched(found, b)); };
    for (const std::uint32_t f : found.pinched)
    {
        for (std::uint32_t half_edge = 3 * f; half_edge < 3 * f + 3; ++half_edge)
        {
            if (partners[half_edge] == kUnnumbered)
                continue;
            unite(next_in_face(half_edge), partners[half_edge]);
            unite(half_edge, next_in_face(partners[half_edge]));
        }
    }
    return corners;
}

} // namespace

bool joined_at_edge(const RestrictedDelaunay& restricted, DelaunayCell delaunay_cell, VertexHandle a,
                    VertexHandle b)
{
    std::optional<Region> inner;
    std::optional<Region> outer;
    const auto first = restricted.triangulation().incident_cells(delaunay_cell, delaunay_cell->index(a),
                                                                 delaunay_cell->index(b));
    auto around = first;
    do
    {
        const Region region = around->info().region;
        std::optional<Region>& same_side = is_inside(region) ? inner : outer;
        if (same_side && *same_side != region)
            return !is_inside(region);
        same_side = region;
    } while (++around != first);
    return is_inside(restricted.oracle().region(0.5 * (position(a) + position(b))));
}

BoundaryComplex collect_boundary(const RestrictedDelaunay& restricted, const CellTable& table)
{
    const VertexTable vertices(restricted);
    FoundFaces found = find_faces(table, vertices);
    CHECK_LT(found.faces.size(), std::numeric_limits<std::uint32_t>::max() / 3);
    name_pinched_faces(found);
    BoundaryComplex complex;
    complex.partner = pair_half_edges(restricted, found);
    UnionFind corners = join_corners(found, complex.partner);

    // One mesh vertex for each vertex with one umbrella, and for each set of corners at a pinched one.
    std::vector<std::uint32_t> number_of_vertex(vertices.handle.size(), kUnnumbered);
    std::vector<std::uint32_t> number_of_corners(3 * found.pinched.size(), kUnnumbered);
    complex.mesh.faces.reserve(found.faces.size());
    complex.origin_of_face.reserve(found.faces.size());
    for (std::uint32_t f = 0; f < found.faces.size(); ++f)
    {
        TriangleMesh::Face face;
        for (std::uint32_t k = 0; k < 3; ++k)
        {
            const std::uint32_t vertex = found.corners[f][k];
            std::uint32_t& number = vertices.pinched[vertex] != 0
                                        ? number_of_corners[corners.find(among_pinched(found, 3 * f + k))]
                                        : number_of_vertex[vertex];
            if (number == kUnnumbered)
            {
                number = static_cast<std::uint32_t>(complex.mesh.vertices.size());
                complex.mesh.vertices.push_back(position(vertices.handle[vertex]));
                complex.vertex_of_copy.push_back(vertices.handle[vertex]);
            }
            face[k] = number;
        }
        complex.mesh.faces.push_back(face);
        complex.origin_of_face.push_back(f);
    }
    complex.faces = std::move(found.faces);
    return complex;
}

} // namespace voroprobe
