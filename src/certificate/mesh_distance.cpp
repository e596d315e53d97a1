#include "certificate/mesh_distance.h"

#include <cmath>
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

using Kernel = CGAL::Simple_cartesian<double>; // a distance is a number, no decision hangs on its last digits
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

Kernel::Point_3 cgal_point(const Point3& p)
{
    return {p.x, p.y, p.z};
}

bool has_area(const Kernel::Triangle_3& triangle)
{
    return triangle.squared_area() > 0.0;
}

} // namespace

struct MeshDistance::Tree
{
    Triangles triangles;
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree;
};

MeshDistance::MeshDistance(const TriangleMesh& mesh) : tree_(std::make_unique<Tree>())
{
    tree_->triangles.reserve(mesh.faces.size());
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const Kernel::Triangle_3 triangle(cgal_point(mesh.corner(face, 0)), cgal_point(mesh.corner(face, 1)),
                                          cgal_point(mesh.corner(face, 2)));
        if (has_area(triangle)) // the tree's closest points need a plane; the sides belong to neighbours, too
            tree_->triangles.push_back(triangle);
    }
    if (tree_->triangles.empty())
        throw UsageError("a mesh without area has no distance; allowed: at least 1 face with area");
    tree_->tree.insert(tree_->triangles.cbegin(), tree_->triangles.cend());
    tree_->tree.build();
    tree_->tree.accelerate_distance_queries();
}

MeshDistance::~MeshDistance() = default;

double MeshDistance::operator()(const Point3& p) const
{
    return std::sqrt(tree_->tree.squared_distance(cgal_point(p)));
}

NearestPoint MeshDistance::nearest(const Point3& p) const
{
    const auto [point, triangle] = tree_->tree.closest_point_and_primitive(cgal_point(p));
    const Kernel::Vector_3 normal = CGAL::cross_product(triangle->vertex(1) - triangle->vertex(0),
                                                        triangle->vertex(2) - triangle->vertex(0));
    return {{point.x(), point.y(), point.z()}, normalized(Vec3{normal.x(), normal.y(), normal.z()})};
}

} // namespace voroprobe
