#include "surface_distance.h"

#include <algorithm>
#include <cmath>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

namespace voroprobe
{
namespace
{

using Kernel = CGAL::Simple_cartesian<double>; // distances to 1e-12 of the coordinates are enough
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 cgal_point(const Point3& p)
{
    return {p.x, p.y, p.z};
}

Point3 random_point(Random& random, const Box3& box)
{
    return {random.uniform(box.min.x, box.max.x), random.uniform(box.min.y, box.max.y),
            random.uniform(box.min.z, box.max.z)};
}

} // namespace

struct DistanceToMesh::Tree
{
    Triangles triangles;
    AabbTree tree;
};

DistanceToMesh::DistanceToMesh(const TriangleMesh& mesh) : tree_(std::make_unique<Tree>())
{
    for (const TriangleMesh::Face& face : mesh.faces)
        tree_->triangles.emplace_back(cgal_point(mesh.corner(face, 0)), cgal_point(mesh.corner(face, 1)),
                                      cgal_point(mesh.corner(face, 2)));
    tree_->tree.insert(tree_->triangles.cbegin(), tree_->triangles.cend());
    tree_->tree.build();
    tree_->tree.accelerate_distance_queries();
}

DistanceToMesh::~DistanceToMesh() = default;

double DistanceToMesh::operator()(const Point3& p) const
{
    return std::sqrt(tree_->tree.squared_distance(cgal_point(p)));
}

std::vector<FaceSample> sample_faces(const TriangleMesh& mesh, int intervals)
{
    std::vector<FaceSample> samples;
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const Point3 a = mesh.corner(face, 0);
        const Vec3 to_b = mesh.corner(face, 1) - a;
        const Vec3 to_c = mesh.corner(face, 2) - a;
        const Vec3 normal = normalized(cross(to_b, to_c));
        for (int i = 0; i <= intervals; ++i)
            for (int j = 0; i + j <= intervals; ++j)
                samples.push_back({a + (static_cast<double>(i) / intervals) * to_b +
                                       (static_cast<double>(j) / intervals) * to_c,
                                   normal});
    }
    return samples;
}

double largest_distance_from_faces(const TriangleMesh& mesh,
                                   const std::function<double(const Point3&)>& distance, int intervals)
{
    double largest = 0.0;
    for (const FaceSample& sample : sample_faces(mesh, intervals))
        largest = std::max(largest, std::abs(distance(sample.point)));
    return largest;
}

double largest_distance_from_faces(const TriangleMesh& mesh, const SurfaceOracle& oracle, double reach,
                                   int intervals)
{
    double largest = 0.0;
    std::vector<Crossing> crossings;
    for (const FaceSample& sample : sample_faces(mesh, intervals))
    {
        double nearest = std::numeric_limits<double>::infinity();
        oracle.find_crossings({sample.point - reach * sample.normal, sample.point + reach * sample.normal},
                              crossings);
        for (const Crossing& crossing : crossings)
            nearest = std::min(nearest, distance(crossing.point, sample.point));
        largest = std::max(largest, nearest);
    }
    return largest;
}

std::vector<Point3> sample_surface(const SurfaceOracle& oracle, std::size_t count, Random& random)
{
    const Box3 around = oracle.domain().expanded(0.1 * oracle.domain().diagonal());
    std::vector<Point3> points;
    std::vector<Crossing> crossings;
    while (points.size() < count)
    {
        const Point3 source = random_point(random, around);
        const Point3 through = random_point(random, around);
        const Vec3 along = around.diagonal() * normalized(through - source);
        oracle.find_crossings({source - along, source + along}, crossings);
        for (const Crossing& crossing : crossings)
            points.push_back(crossing.point);
    }
    return points;
}

double largest_distance_from_points(const std::vector<Point3>& points, const TriangleMesh& mesh)
{
    if (mesh.faces.empty())
        return std::numeric_limits<double>::infinity();
    const DistanceToMesh distance_to_mesh(mesh);
    double largest = 0.0;
    for (const Point3& p : points)
        largest = std::max(largest, distance_to_mesh(p));
    return largest;
}

} // namespace voroprobe
