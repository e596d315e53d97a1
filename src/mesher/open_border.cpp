#include "mesher/open_border.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "mesher/cap_finder.h"
#include "mesher/capped_mesh.h"
#include "mesher/face_settling.h"
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

//! Places a hair away from a vertex, towards the middle of its faces in the fan and of each of them; then
//! nearer ones.
std::vector<Point3> places_in_fan(const TriangleMesh& mesh, std::uint32_t vertex,
                                  const std::vector<std::uint32_t>& fan)
{
    constexpr double kNearer = 0.1;
    const Point3 from = mesh.vertices[vertex];
    std::vector<Vec3> ways(1);
    for (const std::uint32_t c : fan)
    {
        Vec3 sum;
        for (std::size_t k = 0; k < 3; ++k)
            sum += mesh.corner(mesh.faces[c / 3], k) - from;
        ways.front() += sum / static_cast<double>(fan.size());
        ways.push_back(sum);
    }
    std::vector<Point3> places;
    for (const double share : {kHairPerEdge, kNearer * kHairPerEdge})
        for (const Vec3& way : ways)
            places.push_back(from + share * way);
    return places;
}

//! Gives the fan of the corners a vertex of its own.
void give_own_vertex(TriangleMesh& mesh, std::uint32_t vertex, const std::vector<std::uint32_t>& fan,
                     OtherPlaces& others)
{
    const std::vector<Point3> places = places_in_fan(mesh, vertex, fan);
    const auto copy = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const std::uint32_t c : fan)
        mesh.faces[c / 3][c % 3] = copy;
    mesh.vertices.push_back(places.front());
    others[copy].assign(places.begin() + 1, places.end());
}

void split_fans(TriangleMesh& mesh)
{
    OtherPlaces others;
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
        std::vector<std::uint32_t> first; // keeps the vertex, and makes room where the others wrap around it
        for (std::uint32_t root = 0; root < around.size(); ++root)
        {
            if (fans.find(root) != root)
                continue;
            std::vector<std::uint32_t> fan;
            for (std::uint32_t i = root; i < around.size(); ++i)
            {
                if (fans.find(i) == root)
                    fan.push_back(around[i]);
            }
            if (root == 0)
            {
                first = std::move(fan);
                continue;
            }
            others.try_emplace(vertex, places_in_fan(mesh, vertex, first));
            give_own_vertex(mesh, vertex, fan, others);
        }
    }
    settle_crossing_faces(std::move(others), mesh);
}

//! Of the vertices that were moved off it.
OtherPlaces places_on_closed_mesh(const CappedMesh& capped)
{
    OtherPlaces places;
    for (std::uint32_t v = 0; v < capped.place_on_it.size(); ++v)
        if (capped.mesh.vertices[v] != capped.place_on_it[v])
            places[v] = {capped.place_on_it[v]};
    return places;
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
    settle_crossing_faces(places_on_closed_mesh(capped), capped.mesh);
    surface.mesh = without_unused_vertices(capped.mesh);
    surface.surface_of_face = std::move(capped.surface_of_face);
    split_fans(surface.mesh);
}

} // namespace voroprobe
