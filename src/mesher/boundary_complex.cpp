#include "mesher/boundary_complex.h"

#include <limits>

#include "support/check.h"
#include "support/union_find.h"

namespace voroprobe
{
namespace
{

// The corners of the facet opposite each vertex of a positively oriented tetrahedron, counter-clockwise seen
// from outside it.
constexpr int kOutwardCorners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

bool inside(DelaunayCell delaunay_cell)
{
    return is_inside(delaunay_cell->info().region);
}

std::vector<BoundaryFace> collect_faces(const RestrictedDelaunay& restricted,
                                        std::vector<std::uint32_t>& face_of_facet)
{
    std::vector<BoundaryFace> faces;
    for (const DelaunayCell delaunay_cell : restricted.triangulation().finite_cell_handles())
    {
        if (!inside(delaunay_cell))
            continue;
        for (int i = 0; i < 4; ++i)
        {
            if (inside(delaunay_cell->neighbor(i)))
                continue;
            const FacetId id = delaunay_cell->info().facet[static_cast<std::size_t>(i)];
            CHECK_LT(id, kUnqueriedFacet);
            if (id >= face_of_facet.size())
                face_of_facet.resize(id + 1);
            face_of_facet[id] = static_cast<std::uint32_t>(faces.size());
            faces.push_back({delaunay_cell, i, restricted.facet(id).on_border});
        }
    }
    return faces;
}

//! The odd facet met next when turning around the edge (a, b) of `face` through the inside.
FacetId partner_across(const BoundaryFace& face, VertexHandle a, VertexHandle b)
{
    DelaunayCell delaunay_cell = face.inside;
    int entered_at = face.index;
    while (true)
    {
        const int leave_at = 6 - entered_at - delaunay_cell->index(a) - delaunay_cell->index(b);
        const DelaunayCell next = delaunay_cell->neighbor(leave_at);
        if (!inside(next))
            return delaunay_cell->info().facet[static_cast<std::size_t>(leave_at)];
        entered_at = next->index(delaunay_cell);
        delaunay_cell = next;
    }
}

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

} // namespace

VertexHandle corner(const BoundaryFace& face, std::size_t k)
{
    return face.inside->vertex(kOutwardCorners[face.index][k]);
}

BoundaryComplex collect_boundary(const RestrictedDelaunay& restricted)
{
    BoundaryComplex complex;
    std::vector<std::uint32_t> face_of_facet;
    complex.faces = collect_faces(restricted, face_of_facet);
    const auto& faces = complex.faces;
    CHECK_LT(faces.size(), std::numeric_limits<std::uint32_t>::max() / 3);

    // Corners joined across edges are one vertex of the mesh.
    UnionFind corners(3 * faces.size());
    complex.partner.resize(3 * faces.size());
    for (std::uint32_t f = 0; f < faces.size(); ++f)
    {
        for (std::uint32_t k = 0; k < 3; ++k)
        {
            const VertexHandle a = corner(faces[f], k);
            const VertexHandle b = corner(faces[f], (k + 1) % 3);
            const std::uint32_t partner = face_of_facet[partner_across(faces[f], a, b)];
            const std::uint32_t corner_b = corner_number(faces, partner, b); // the partner runs from b to a
            complex.partner[3 * f + k] = corner_b;
            corners.unite(3 * f + k, corner_number(faces, partner, a));
            corners.unite(3 * f + (k + 1) % 3, corner_b);
        }
    }

    constexpr auto kUnnumbered = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> vertex_of_corner(3 * faces.size(), kUnnumbered);
    for (std::uint32_t f = 0; f < faces.size(); ++f)
    {
        TriangleMesh::Face face;
        for (std::uint32_t k = 0; k < 3; ++k)
        {
            std::uint32_t& number = vertex_of_corner[corners.find(3 * f + k)];
            if (number == kUnnumbered)
            {
                number = static_cast<std::uint32_t>(complex.mesh.vertices.size());
                complex.mesh.vertices.push_back(position(corner(faces[f], k)));
                complex.vertex_of_copy.push_back(corner(faces[f], k));
            }
            face[k] = number;
        }
        complex.mesh.faces.push_back(face);
        complex.origin_of_face.push_back(f);
    }
    return complex;
}

} // namespace voroprobe
