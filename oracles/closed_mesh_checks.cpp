// This file follows:
// Afra Zomorodian and Herbert Edelsbrunner, Fast software for box intersections, 2002 (in CGAL), for the
// pairs of faces.

#include "oracles/closed_mesh_checks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Face = TriangleMesh::Face;
using FaceBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
using Edge = std::array<std::uint32_t, 2>;

std::string place_text(const Point3& p)
{
    return std::string("(") + number_text(p.x) + ", " + number_text(p.y) + ", " + number_text(p.z) + ')';
}

//! Every edge of every face, sorted, smaller corner first.
std::vector<Edge> edges_of_faces(const TriangleMesh& mesh)
{
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.faces.size());
    for (const Face& face : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i)
            edges.push_back({std::min(face[i], face[(i + 1) % 3]), std::max(face[i], face[(i + 1) % 3])});
    std::sort(edges.begin(), edges.end());
    return edges;
}

//! The edges on an odd number of faces. Faces that name a corner twice count their other edge twice.
std::vector<Edge> odd_edges(const TriangleMesh& mesh)
{
    const std::vector<Edge> edges = edges_of_faces(mesh);
    std::vector<Edge> odd;
    for (auto first = edges.begin(); first != edges.end();)
    {
        const auto last = std::upper_bound(first, edges.end(), *first);
        if ((last - first) % 2 == 1 && (*first)[0] != (*first)[1])
            odd.push_back(*first);
        first = last;
    }
    return odd;
}

Point point(const TriangleMesh& mesh, std::uint32_t vertex)
{
    const Point3& p = mesh.vertices[vertex];
    return {p.x, p.y, p.z};
}

Kernel::Triangle_3 triangle(const TriangleMesh& mesh, const Face& face)
{
    return {point(mesh, face[0]), point(mesh, face[1]), point(mesh, face[2])};
}

//! The face turned so that its shared corners come first; their number.
std::size_t shared_first(Face& face, const Face& other)
{
    const auto is_shared = [&](std::uint32_t vertex)
    { return std::find(other.begin(), other.end(), vertex) != other.end(); };
    return static_cast<std::size_t>(std::stable_partition(face.begin(), face.end(), is_shared) -
                                    face.begin());
}

//! Faces that share the edge (a[0], a[1]) meet elsewhere only where one is folded onto the other.
bool are_folded(const TriangleMesh& mesh, const Face& a, const Face& b)
{
    const Point p = point(mesh, a[0]);
    const Point q = point(mesh, a[1]);
    const Point r = point(mesh, a[2]);
    const Point s = point(mesh, b[2]);
    return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
}

//! Faces that share the corner a[0]: what they have in common is convex and holds that corner, so if there is
//! more, it reaches the side opposite the corner in one of them.
bool meet_beyond_corner(const TriangleMesh& mesh, const Face& a, const Face& b)
{
    const Kernel::Segment_3 opposite_in_a(point(mesh, a[1]), point(mesh, a[2]));
    const Kernel::Segment_3 opposite_in_b(point(mesh, b[1]), point(mesh, b[2]));
    return CGAL::do_intersect(opposite_in_a, triangle(mesh, b)) ||
           CGAL::do_intersect(opposite_in_b, triangle(mesh, a));
}

bool meet_elsewhere(const TriangleMesh& mesh, Face a, Face b)
{
    const std::size_t shared = shared_first(a, b);
    shared_first(b, a);
    switch (shared)
    {
    case 0:
        return CGAL::do_intersect(triangle(mesh, a), triangle(mesh, b));
    case 1:
        return meet_beyond_corner(mesh, a, b);
    case 2:
        return are_folded(mesh, a, b);
    default:
        return true; // the same three corners
    }
}

std::vector<FaceBox> boxes_of_faces(const TriangleMesh& mesh)
{
    std::vector<FaceBox> boxes;
    boxes.reserve(mesh.faces.size());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
        if (const Kernel::Triangle_3 t = triangle(mesh, mesh.faces[f]); !t.is_degenerate())
            boxes.emplace_back(t.bbox(), f);
    return boxes;
}

} // namespace

void require_closed(const TriangleMesh& mesh, const std::string& name)
{
    if (mesh.faces.empty())
        throw InputError(name + " has no faces; it must be a closed surface");
    for (const Point3& p : mesh.vertices)
        if (!is_finite(p))
            throw InputError(name + " has a vertex with a coordinate that is not a finite number");
    const std::vector<Edge> odd = odd_edges(mesh);
    if (!odd.empty())
        throw InputError(name + " is not closed: " + count_text(odd.size()) +
                         " edges are on an odd number of faces, the first at " +
                         place_text(mesh.vertices[odd.front()[0]]) + "; it must bound an object");
}

void require_no_crossing_faces(const TriangleMesh& mesh, const std::string& name)
{
    std::vector<FaceBox> boxes = boxes_of_faces(mesh);
    std::size_t count = 0;
    std::uint32_t first = static_cast<std::uint32_t>(mesh.faces.size());
    const auto look = [&](const FaceBox& a, const FaceBox& b)
    {
        if (!meet_elsewhere(mesh, mesh.faces[a.info()], mesh.faces[b.info()]))
            return;
        ++count;
        first = std::min({first, a.info(), b.info()});
    };
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), look);
    if (count > 0)
        throw InputError(
            name + " crosses itself: " + count_text(count) + " pairs of faces meet, the first at " +
            place_text(mesh.corner(mesh.faces[first], 0)) + "; which side is inside would be a guess");
}

} // namespace voroprobe
