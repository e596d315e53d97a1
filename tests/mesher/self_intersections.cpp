// This file follows:
// Afra Zomorodian and Herbert Edelsbrunner, Fast software for box intersections, 2002 (in CGAL), for the
// pairs.

#include "self_intersections.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

namespace voroprobe
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using FaceBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
using Face = TriangleMesh::Face;

Point point(const TriangleMesh& mesh, std::uint32_t vertex)
{
    const Point3& p = mesh.vertices[vertex];
    return {p.x, p.y, p.z};
}

Triangle triangle(const TriangleMesh& mesh, const Face& face)
{
    return {point(mesh, face[0]), point(mesh, face[1]), point(mesh, face[2])};
}

//! The face turned so that its shared corners come first; their number.
std::size_t shared_first(Face& face, const Face& other)
{
    const auto end = std::stable_partition(
        face.begin(), face.end(),
        [&](std::uint32_t vertex) { return std::find(other.begin(), other.end(), vertex) != other.end(); });
    return static_cast<std::size_t>(end - face.begin());
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
    const Face a_before = a;
    switch (shared_first(a, b))
    {
    case 0:
        return CGAL::do_intersect(triangle(mesh, a), triangle(mesh, b));
    case 1:
        shared_first(b, a_before);
        return meet_beyond_corner(mesh, a, b);
    case 2:
        shared_first(b, a_before);
        return are_folded(mesh, a, b);
    default:
        return true; // the same three corners
    }
}

} // namespace

std::vector<FacePair> find_self_intersections(const TriangleMesh& mesh)
{
    std::vector<FacePair> found;
    std::vector<FaceBox> boxes;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    {
        const Triangle t = triangle(mesh, mesh.faces[f]);
        if (t.is_degenerate())
            found.emplace_back(f, f);
        else
            boxes.emplace_back(t.bbox(), f);
    }
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                  [&](const FaceBox& a, const FaceBox& b)
                                  {
                                      if (meet_elsewhere(mesh, mesh.faces[a.info()], mesh.faces[b.info()]))
                                          found.push_back(std::minmax(a.info(), b.info()));
                                  });
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace voroprobe
