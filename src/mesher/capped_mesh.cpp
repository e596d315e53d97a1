#include "mesher/capped_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "mesh/vertex_normals.h"

namespace voroprobe
{
namespace
{

using Face = TriangleMesh::Face;

//! The surface across a face is no farther than this share of its longest side: the height of an arch as wide
//! as high.
constexpr double kAcross = 0.5;

SurfacePart part_of(const Crossing& crossing)
{
    return crossing.on_border ? SurfacePart::kCap : SurfacePart::kProper;
}

//! The shortest side at each vertex: what lies farther off is another place.
std::vector<double> shortest_sides(const TriangleMesh& mesh)
{
    std::vector<double> shortest(mesh.vertices.size(), std::numeric_limits<double>::infinity());
    for (const Face& face : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i)
        {
            const std::uint32_t a = face[i];
            const std::uint32_t b = face[(i + 1) % 3];
            const double side = distance(mesh.vertices[a], mesh.vertices[b]);
            shortest[a] = std::min(shortest[a], side);
            shortest[b] = std::min(shortest[b], side);
        }
    return shortest;
}

double longest_side(const TriangleMesh& mesh, const Face& face)
{
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, distance(mesh.corner(face, i), mesh.corner(face, (i + 1) % 3)));
    return longest;
}

Point3 middle(const TriangleMesh& mesh, const Face& face)
{
    return (mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3.0;
}

std::vector<SurfacePart> parts_of_vertices(const TriangleMesh& mesh, CapFinder& caps)
{
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const std::vector<double> reach = shortest_sides(mesh);
    std::vector<SurfacePart> parts;
    parts.reserve(mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    {
        const auto crossing = caps.nearest(mesh.vertices[v], normals[v], reach[v]);
        parts.push_back(crossing ? part_of(*crossing) : SurfacePart::kProper);
    }
    return parts;
}

//! Whether a ball around p may reach beyond the box.
bool is_near_side(const Box3& box, const Point3& p, double radius)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (p[axis] - box.min[axis] < radius || box.max[axis] - p[axis] < radius)
            return true;
    return false;
}

//! Replaces a face by three around a new vertex.
void divide(CappedMesh& capped, std::size_t f, std::uint32_t vertex)
{
    const Face face = capped.mesh.faces[f];
    capped.mesh.faces[f] = {face[0], face[1], vertex};
    for (const Face& added : {Face{face[1], face[2], vertex}, Face{face[2], face[0], vertex}})
    {
        capped.mesh.faces.push_back(added);
        capped.surface_of_face.push_back(capped.surface_of_face[f]);
    }
}

void divide_faces_over_other_part(const Box3& domain, CapFinder& caps, CappedMesh& capped)
{
    const std::size_t count = capped.mesh.faces.size();
    for (std::size_t f = 0; f < count; ++f)
    {
        const Face face = capped.mesh.faces[f];
        const SurfacePart part = capped.part[face[0]];
        if (capped.part[face[1]] != part || capped.part[face[2]] != part)
            continue;
        const Point3 at = middle(capped.mesh, face);
        if (part == SurfacePart::kProper && !is_near_side(domain, at, longest_side(capped.mesh, face)))
            continue;
        const auto crossing = crossing_across(capped.mesh, face, caps);
        if (crossing && part_of(*crossing) != part)
            divide(capped, f, capped.add_vertex(crossing->point, at, part_of(*crossing)));
    }
}

} // namespace

std::uint32_t CappedMesh::add_vertex(const Point3& at, const Point3& place_on_closed_mesh, SurfacePart of)
{
    mesh.vertices.push_back(at);
    place_on_it.push_back(place_on_closed_mesh);
    part.push_back(of);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

CappedMesh with_parts(const Box3& domain, CapFinder& caps, ExtractedSurface surface)
{
    CappedMesh capped{.mesh = std::move(surface.mesh),
                      .surface_of_face = std::move(surface.surface_of_face),
                      .part = {},
                      .place_on_it = {}};
    capped.part = parts_of_vertices(capped.mesh, caps);
    capped.place_on_it = capped.mesh.vertices;
    divide_faces_over_other_part(domain, caps, capped);
    return capped;
}

std::optional<Crossing> crossing_across(const TriangleMesh& mesh, const Face& face, CapFinder& caps)
{
    const Point3 a = mesh.corner(face, 0);
    const Vec3 out = normalized(cross(mesh.corner(face, 1) - a, mesh.corner(face, 2) - a));
    return caps.nearest(middle(mesh, face), out, kAcross * longest_side(mesh, face));
}

} // namespace voroprobe
