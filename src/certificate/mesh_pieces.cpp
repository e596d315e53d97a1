#include "certificate/mesh_pieces.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "mesh/topology.h"

namespace voroprobe
{

namespace
{

using Face = TriangleMesh::Face;

//! Each vertex once for every piece it is a corner of.
void count_vertices(const TriangleMesh& mesh, MeshPieces& result)
{
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> first_piece(mesh.vertices.size(), kNone);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> further; // vertices and pieces that share them
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (std::size_t i = 0; !names_a_vertex_twice(mesh.faces[f]) && i < 3; ++i)
        {
            const std::uint32_t v = mesh.faces[f][i];
            const std::uint32_t piece = result.piece_of_face[f];
            if (first_piece[v] == kNone)
            {
                first_piece[v] = piece;
                ++result.pieces[piece].euler_characteristic;
            }
            else if (first_piece[v] != piece)
                further.emplace_back(v, piece);
        }
    std::sort(further.begin(), further.end());
    further.erase(std::unique(further.begin(), further.end()), further.end());
    for (const auto& [v, piece] : further)
        ++result.pieces[piece].euler_characteristic;
}

void count_edges(const TriangleMesh& mesh, const EdgeTable& edges, MeshPieces& result)
{
    edges.for_each_edge(
        [&](std::span<const EdgeTable::Side> sides)
        {
            const auto faces_on_it =
                std::count_if(sides.begin(), sides.end(),
                              [&](const EdgeTable::Side& side)
                              { return !names_a_vertex_twice(mesh.faces[side.corner / 3]); });
            MeshPiece& piece = result.pieces[result.piece_of_face[sides.front().corner / 3]];
            piece.euler_characteristic -= faces_on_it > 0 ? 1 : 0;
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
    return split_into_pieces(mesh, EdgeTable(mesh));
}

MeshPieces split_into_pieces(const TriangleMesh& mesh, const EdgeTable& edges)
{
    MeshPieces result;
    result.piece_of_face = component_of_faces(mesh, edges);
    const auto last = std::max_element(result.piece_of_face.begin(), result.piece_of_face.end());
    result.pieces.resize(mesh.faces.empty() ? 0 : std::size_t{*last} + 1);
    count_vertices(mesh, result);
    count_edges(mesh, edges, result);
    sum_up_faces(mesh, result);
    return result;
}

} // namespace voroprobe
