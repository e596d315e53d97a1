#include "mesher/boundary_complex.h"

#include <limits>
#include <optional>

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

std::vector<BoundaryFace> collect_faces(const CellTable& table)
{
    std::vector<BoundaryFace> faces;
    for (CellTable::Number c = 0; c < table.size(); ++c)
    {
        if (!is_inside(table.region(c))) // infinite cells are outside
            continue;
        for (std::size_t i = 0; i < 4; ++i)
        {
            const CellTable::Number next = table.neighbors(c)[i];
            if (is_inside(table.region(next)))
                continue;
            // The table of facets has served: from here on both sides of the facet name its face.
            const DelaunayCell delaunay_cell = table.cell(c);
            const DelaunayCell outside = table.cell(next);
            const auto face = static_cast<std::uint32_t>(faces.size());
            delaunay_cell->info().facet[i] = face;
            outside->info().facet[static_cast<std::size_t>(outside->index(delaunay_cell))] = face;
            faces.push_back({delaunay_cell, static_cast<int>(i)});
        }
    }
    return faces;
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
std::vector<std::uint32_t> pair_half_edges(const RestrictedDelaunay& restricted,
                                           const std::vector<BoundaryFace>& faces)
{
    std::vector<std::uint32_t> partners(3 * faces.size(), kUnnumbered);
    const EdgePairing pairing(restricted);
    for (std::uint32_t half_edge = 0; half_edge < partners.size(); ++half_edge)
    {
        if (partners[half_edge] != kUnnumbered)
            continue; // the partner's partner
        const BoundaryFace& face = faces[half_edge / 3];
        const VertexHandle a = corner(face, half_edge % 3);
        const VertexHandle b = corner(face, next_in_face(half_edge) % 3);
        if (!a->info().pinched && !b->info().pinched)
            continue;
        const std::uint32_t partner =
            corner_number(faces, pairing.partner_across(face, a, b), b); // runs from b to a
        partners[half_edge] = partner;
        partners[partner] = half_edge;
    }
    return partners;
}

//! Corners joined across paired edges.
UnionFind join_corners(const std::vector<BoundaryFace>& faces, const std::vector<std::uint32_t>& partners)
{
    UnionFind corners(3 * faces.size());
    for (std::uint32_t half_edge = 0; half_edge < partners.size(); ++half_edge)
    {
        if (partners[half_edge] == kUnnumbered)
            continue;
        corners.unite(next_in_face(half_edge), partners[half_edge]);
        corners.unite(half_edge, next_in_face(partners[half_edge]));
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
    BoundaryComplex complex;
    complex.faces = collect_faces(table);
    CHECK_LT(complex.faces.size(), std::numeric_limits<std::uint32_t>::max() / 3);
    complex.partner = pair_half_edges(restricted, complex.faces);
    UnionFind corners = join_corners(complex.faces, complex.partner);

    // One mesh vertex for each vertex with one umbrella, and for each set of corners at a pinched one.
    std::vector<std::uint32_t> number_of_vertex(restricted.vertex_index_bound(), kUnnumbered);
    std::vector<std::uint32_t> number_of_corners(3 * complex.faces.size(), kUnnumbered);
    complex.mesh.faces.reserve(complex.faces.size());
    complex.origin_of_face.reserve(complex.faces.size());
    for (std::uint32_t f = 0; f < complex.faces.size(); ++f)
    {
        TriangleMesh::Face face;
        for (std::uint32_t k = 0; k < 3; ++k)
        {
            const VertexHandle vertex = corner(complex.faces[f], k);
            std::uint32_t& number = vertex->info().pinched ? number_of_corners[corners.find(3 * f + k)]
                                                           : number_of_vertex[vertex->info().index];
            if (number == kUnnumbered)
            {
                number = static_cast<std::uint32_t>(complex.mesh.vertices.size());
                complex.mesh.vertices.push_back(position(vertex));
                complex.vertex_of_copy.push_back(vertex);
            }
            face[k] = number;
        }
        complex.mesh.faces.push_back(face);
        complex.origin_of_face.push_back(f);
    }
    return complex;
}

} // namespace voroprobe
