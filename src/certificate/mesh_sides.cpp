#include "certificate/mesh_sides.h"

#include <array>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "geometry/box3.h"

namespace voroprobe
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

//! Ways out, along no axis and no diagonal: one that meets a side of a face counts it twice.
constexpr std::array<Vec3, 3> kWaysOut{
    {{0.8734, 0.3917, 0.2891}, {-0.3129, 0.9071, 0.2815}, {0.2317, -0.3571, 0.9049}}};

Kernel::Point_3 cgal_point(const Point3& p)
{
    return {p.x, p.y, p.z};
}

Triangles triangles_of(const TriangleMesh& mesh)
{
    Triangles triangles;
    triangles.reserve(mesh.faces.size());
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const Kernel::Triangle_3 triangle(cgal_point(mesh.corner(face, 0)), cgal_point(mesh.corner(face, 1)),
                                          cgal_point(mesh.corner(face, 2)));
        if (!triangle.is_degenerate())
            triangles.push_back(triangle);
    }
    return triangles;
}

//! Farther than from any point of the mesh's box to any other.
double way_out(const TriangleMesh& mesh, std::span<const Point3> points)
{
    Box3 box;
    for (const Point3& p : mesh.vertices)
        box.include(p);
    for (const Point3& p : points)
        box.include(p);
    return 2.0 * box.diagonal();
}

} // namespace

std::vector<bool> enclosed_by(const TriangleMesh& mesh, std::span<const Point3> points)
{
    const Triangles triangles = triangles_of(mesh);
    const Tree tree(triangles.cbegin(), triangles.cend());
    const double length = way_out(mesh, points);
    std::vector<bool> enclosed;
    enclosed.reserve(points.size());
    for (const Point3& p : points)
    {
        int votes = 0;
        for (const Vec3& direction : kWaysOut)
        {
            const Kernel::Segment_3 segment(cgal_point(p), cgal_point(p + length * direction));
            votes += tree.number_of_intersected_primitives(segment) % 2 == 1 ? 1 : 0;
        }
        enclosed.push_back(votes >= 2);
    }
    return enclosed;
}

} // namespace voroprobe
