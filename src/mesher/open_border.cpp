#include "mesher/open_border.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "mesher/pinched_edges.h"
#include "support/union_find.h"

namespace voroprobe
{
namespace
{

//! Whether the whole face lies on one side of the box.
bool lies_on_side(const TriangleMesh& mesh, const TriangleMesh::Face& face, const Box3& box, double tolerance)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        for (const double side : {box.min[axis], box.max[axis]})
        {
            if (std::all_of(face.begin(), face.end(),
                            [&](std::uint32_t vertex)
                            { return std::abs(mesh.vertices[vertex][axis] - side) <= tolerance; }))
                return true;
        }
    }
    return false;
}

//! The corners of a mesh, number 3 f + k being corner k of face f, by their vertex.
std::vector<std::vector<std::uint32_t>> corners_of_vertices(const TriangleMesh& mesh)
{
    std::vector<std::vector<std::uint32_t>> corners(mesh.vertices.size());
    for (std::uint32_t c = 0; c < 3 * mesh.faces.size(); ++c)
        corners[mesh.faces[c / 3][c % 3]].push_back(c);
    return corners;
}

//! Whether two corners at one vertex belong to faces that share an edge there.
bool are_neighbors(const TriangleMesh& mesh, std::uint32_t c, std::uint32_t d)
{
    const auto next = [&](std::uint32_t corner) { return mesh.faces[corner / 3][(corner % 3 + 1) % 3]; };
    const auto previous = [&](std::uint32_t corner) { return mesh.faces[corner / 3][(corner % 3 + 2) % 3]; };
    return next(c) == previous(d) || previous(c) == next(d);
}

//! Gives the fan of the corners a vertex of its own, moved towards the middle of its faces.
void give_own_vertex(TriangleMesh& mesh, std::uint32_t vertex, const std::vector<std::uint32_t>& fan)
{
    const Point3 from = mesh.vertices[vertex];
    Vec3 sum;
    for (const std::uint32_t c : fan)
    {
        for (std::size_t k = 0; k < 3; ++k)
            sum += mesh.corner(mesh.faces[c / 3], k) - from;
    }
    for (const std::uint32_t c : fan)
        mesh.faces[c / 3][c % 3] = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(from + (kHairPerEdge / static_cast<double>(fan.size())) * sum);
}

void split_fans(TriangleMesh& mesh)
{
    const auto corners = corners_of_vertices(mesh);
    for (std::uint32_t vertex = 0; vertex < corners.size(); ++vertex)
    {
        const auto& around = corners[vertex];
        UnionFind fans(around.size());
        for (std::uint32_t i = 0; i < around.size(); ++i)
        {
            for (std::uint32_t j = i + 1; j < around.size(); ++j)
            {
                if (are_neighbors(mesh, around[i], around[j]))
                    fans.unite(i, j);
            }
        }
        for (std::uint32_t root = 1; root < around.size();
             ++root) // the fan of the first corner keeps the vertex
        {
            if (fans.find(root) != root)
                continue;
            std::vector<std::uint32_t> fan;
            for (std::uint32_t i = root; i < around.size(); ++i)
            {
                if (fans.find(i) == root)
                    fan.push_back(around[i]);
            }
            give_own_vertex(mesh, vertex, fan);
        }
    }
}

} // namespace

void open_border(const Box3& box, double tolerance, ExtractedSurface& surface)
{
    TriangleMesh& mesh = surface.mesh;
    std::vector<bool> kept;
    kept.reserve(mesh.faces.size());
    for (const TriangleMesh::Face& face : mesh.faces)
        kept.push_back(!lies_on_side(mesh, face, box, tolerance));
    for (std::size_t f = 0, to = 0; f < kept.size(); ++f)
    {
        if (kept[f])
            surface.surface_of_face[to++] = surface.surface_of_face[f];
    }
    mesh = with_faces(mesh, kept);
    surface.surface_of_face.resize(mesh.faces.size());
    split_fans(mesh);
}

} // namespace voroprobe
