#include "certificate/mesh_pieces.h"

#include <algorithm>

#include "mesh/topology.h"
#include "support/grouping.h"

namespace voroprobe
{

namespace
{

using Face = TriangleMesh::Face;

bool names_a_vertex_twice(const Face& face)
{
    return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

//! A corner of a face, or a side that runs to `to`, seen from the vertex it is grouped under.
struct Mark
{
    std::uint32_t piece;
    std::uint32_t to;

    friend auto operator<=>(const Mark&, const Mark&) = default;
};

//! Calls `visit(mark, number)` for every different mark at every vertex.
template <typename Visitor>
void for_each_run(Grouping<Mark>& marks, std::size_t vertex_count, Visitor visit)
{
    for (std::size_t v = 0; v < vertex_count; ++v)
    {
        const auto here = marks.of(v);
        std::sort(here.begin(), here.end());
        for (std::size_t begin = 0, end = 0; begin < here.size(); begin = end)
        {
            while (end < here.size() && here[end] == here[begin])
                ++end;
            visit(here[begin], end - begin);
        }
    }
}

void count_vertices(const TriangleMesh& mesh, MeshPieces& result)
{
    Grouping<Mark> corners(mesh.vertices.size(),
                           [&](auto&& visit)
                           {
                               for (std::size_t f = 0; f < mesh.faces.size(); ++f)
                                   if (!names_a_vertex_twice(mesh.faces[f]))
                                       for (const std::uint32_t v : mesh.faces[f])
                                           visit(v, Mark{result.piece_of_face[f], 0});
                           });
    for_each_run(corners, mesh.vertices.size(),
                 [&](const Mark& corner, std::size_t)
                 { ++result.pieces[corner.piece].euler_characteristic; });
}

void count_edges(const TriangleMesh& mesh, MeshPieces& result)
{
    Grouping<Mark> sides(mesh.vertices.size(),
                         [&](auto&& visit)
                         {
                             for (std::size_t f = 0; f < mesh.faces.size(); ++f)
                                 for (std::size_t i = 0; !names_a_vertex_twice(mesh.faces[f]) && i < 3; ++i)
                                 {
                                     const auto [low, high] =
                                         std::minmax(mesh.faces[f][i], mesh.faces[f][(i + 1) % 3]);
                                     visit(low, Mark{result.piece_of_face[f], high});
                                 }
                         });
    for_each_run(sides, mesh.vertices.size(),
                 [&](const Mark& side, std::size_t faces_on_it)
                 {
                     MeshPiece& piece = result.pieces[side.piece];
                     --piece.euler_characteristic;
                     piece.boundary_edges += faces_on_it == 1 ? 1 : 0;
                     piece.crowded_edges += faces_on_it > 2 ? 1 : 0;
                 });
}

void sum_up_faces(const TriangleMesh& mesh, MeshPieces& result)
{
    // Of each piece one vertex: the volume of a speck is below the rounding of the coordinates from anywhere
    // else.
    std::vector<Point3> apex_of_piece(result.pieces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
        const Face& face = mesh.faces[f];
        MeshPiece& piece = result.pieces[result.piece_of_face[f]];
        Point3& apex = apex_of_piece[result.piece_of_face[f]];
        if (piece.faces == 0)
            apex = mesh.corner(face, 0);
        ++piece.faces;
        piece.euler_characteristic += names_a_vertex_twice(face) ? 0 : 1;
        const Vec3 a = mesh.corner(face, 0) - apex;
        const Vec3 b = mesh.corner(face, 1) - apex;
        const Vec3 c = mesh.corner(face, 2) - apex;
        piece.area += 0.5 * norm(cross(b - a, c - a));
        piece.enclosed_volume += dot(a, cross(b, c)) / 6.0;
        for (const std::uint32_t v : face)
            piece.box.include(mesh.vertices[v]);
    }
}

} // namespace

MeshPieces split_into_pieces(const TriangleMesh& mesh)
{
    MeshPieces result;
    result.piece_of_face = component_of_faces(mesh);
    const auto last = std::max_element(result.piece_of_face.begin(), result.piece_of_face.end());
    result.pieces.resize(mesh.faces.empty() ? 0 : std::size_t{*last} + 1);
    count_vertices(mesh, result);
    count_edges(mesh, result);
    sum_up_faces(mesh, result);
    return result;
}

} // namespace voroprobe
