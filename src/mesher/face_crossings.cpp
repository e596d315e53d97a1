#include "mesher/face_crossings.h"

#include <algorithm>
#include <array>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

namespace voroprobe
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(const TriangleMesh& mesh, std::uint32_t vertex)
{
    const Point3& p = mesh.vertices[vertex];
    return {p.x, p.y, p.z};
}

Kernel::Triangle_3 triangle(const TriangleMesh& mesh, const TriangleMesh::Face& face)
{
    return {point(mesh, face[0]), point(mesh, face[1]), point(mesh, face[2])};
}

//! The face turned so that its corners shared with `other` come first; returns their number.
std::size_t shared_first(TriangleMesh::Face& face, const TriangleMesh::Face& other)
{
    const auto middle = std::stable_partition(
        face.begin(), face.end(),
        [&](std::uint32_t vertex) { return std::find(other.begin(), other.end(), vertex) != other.end(); });
    return static_cast<std::size_t>(middle - face.begin());
}

bool opposite_edge_meets(const TriangleMesh& mesh, const TriangleMesh::Face& f, const TriangleMesh::Face& g)
{
    return CGAL::do_intersect(Kernel::Segment_3(point(mesh, f[1]), point(mesh, f[2])), triangle(mesh, g));
}

//! Faces f and g on a common edge, their first two corners: whether they lie in one plane on the same side of
//! it.
bool folded(const TriangleMesh& mesh, const TriangleMesh::Face& f, const TriangleMesh::Face& g)
{
    const auto a = point(mesh, f[0]);
    const auto b = point(mesh, f[1]);
    const auto c = point(mesh, f[2]);
    const auto d = point(mesh, g[2]);
    return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
}

} // namespace

bool faces_cross(const TriangleMesh& mesh, const TriangleMesh::Face& f, const TriangleMesh::Face& g)
{
    TriangleMesh::Face f_turned = f;
    TriangleMesh::Face g_turned = g;
    const std::size_t shared = shared_first(f_turned, g);
    shared_first(g_turned, f);
    switch (shared)
    {
    case 0:
        return CGAL::do_intersect(triangle(mesh, f), triangle(mesh, g));
    case 1:
        return opposite_edge_meets(mesh, f_turned, g_turned) || opposite_edge_meets(mesh, g_turned, f_turned);
    case 2:
        return folded(mesh, f_turned, g_turned);
    default:
        return true; // the same three corners
    }
}

} // namespace voroprobe
