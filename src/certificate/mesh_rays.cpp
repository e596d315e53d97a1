#include "certificate/mesh_rays.h"

#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include "support/error.h"

namespace voroprobe
{

namespace
{

using Kernel = CGAL::Simple_cartesian<double>; // lengths are measured; no decision hangs on their last digits
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

Kernel::Point_3 cgal_point(const Point3& p)
{
    return {p.x, p.y, p.z};
}

} // namespace

struct MeshRays::Tree
{
    Triangles triangles;
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree;
};

MeshRays::MeshRays(const TriangleMesh& mesh) : tree_(std::make_unique<Tree>())
{
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const Kernel::Triangle_3 triangle(cgal_point(mesh.corner(face, 0)), cgal_point(mesh.corner(face, 1)),
                                          cgal_point(mesh.corner(face, 2)));
        if (triangle.squared_area() > 0.0)
            tree_->triangles.push_back(triangle);
    }
    if (tree_->triangles.empty())
        throw UsageError("a mesh without area meets no ray; allowed: at least 1 face with area");
    tree_->tree.insert(tree_->triangles.cbegin(), tree_->triangles.cend());
    tree_->tree.build();
}

MeshRays::~MeshRays() = default;

std::optional<MeshRays::Hit> MeshRays::first_hit(const Point3& origin, const Vec3& direction,
                                                 double beyond) const
{
    const Point3 start = origin + beyond * direction;
    const Kernel::Ray_3 ray(cgal_point(start), Kernel::Vector_3(direction.x, direction.y, direction.z));
    const auto found = tree_->tree.first_intersection(ray);
    if (!found)
        return std::nullopt;
    const auto* point = boost::get<Kernel::Point_3>(&found->first);
    const auto* along = boost::get<Kernel::Segment_3>(&found->first); // the ray lies in the face
    const Kernel::Point_3 hit = point != nullptr ? *point : along->source();
    const Kernel::Triangle_3& face = *found->second;
    const Kernel::Vector_3 n = CGAL::cross_product(face[1] - face[0], face[2] - face[0]);
    const Point3 p{hit.x(), hit.y(), hit.z()};
    return Hit{distance(origin, p), p, normalized(Vec3{n.x(), n.y(), n.z()})};
}

} // namespace voroprobe
