#include "mesher/open_border.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "mesher/cap_finder.h"
#include "mesher/capped_mesh.h"
#include "mesher/moved_faces.h"
#include "mesher/pinched_edges.h"
#include "mesher/rim.h"
#include "mesher/rim_corners.h"
#include "support/union_find.h"

namespace voroprobe
{
namespace
{

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

TriangleMesh without_unused_vertices(const TriangleMesh& mesh)
{
    return with_faces(mesh, std::vector<bool>(mesh.faces.size(), true));
}

} // namespace

void open_border(const SurfaceOracle& oracle, ExtractedSurface& surface)
{
    CapFinder caps(oracle);
    CappedMesh capped = with_parts(oracle.domain(), caps, std::move(surface));
    cut_along_rim(caps, capped);
    add_rim_corners(oracle.domain(), caps, capped);
    put_back_where_faces_cross(capped.place_on_it, capped.mesh);
    surface.mesh = without_unused_vertices(capped.mesh);
    surface.surface_of_face = std::move(capped.surface_of_face);
    split_fans(surface.mesh);
}

} // namespace voroprobe
