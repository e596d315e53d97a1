#include "certificate/mesh_sides.h"

#include <array>
#include <cmath>
#include <limits>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace voroprobe
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

//! Ways out, along no axis and no diagonal: one that meets a side of a face counts it twice.
constexpr std::array<Vec3, 3> kWaysOut{
    {{0.8734, 0.3917, 0.2891}, {-0.3129, 0.9071, 0.2815}, {0.2317, -0.3571, 0.9049}}};

//! Boxes are grown by so much of the length of a way out before it is held against them: more than rounding
//! can do.
constexpr double kBoxRounding = 1e-12;

Kernel::Point_3 cgal_point(const Point3& p)
{
    return {p.x, p.y, p.z};
}

//! Whether the half-line from a point in a direction without zeros may meet a box.
class BoxesOnWay
{
public:
    BoxesOnWay(const Point3& from, const Vec3& way)
        : from_(from), inverse_{1.0 / way.x, 1.0 / way.y, 1.0 / way.z}, margin_(kBoxRounding * norm(way))
    {
    }

    [[nodiscard]] bool operator()(const Box3& box) const
    {
        double first = 0.0;
        double last = std::numeric_limits<double>::infinity();
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const double low = (box.min[axis] - margin_ - from_[axis]) * inverse_[axis];
            const double high = (box.max[axis] + margin_ - from_[axis]) * inverse_[axis];
            first = std::max(first, std::min(low, high));
            last = std::min(last, std::max(low, high));
        }
        return first <= last;
    }

private:
    Point3 from_;
    Vec3 inverse_;
    double margin_;
};

bool meets(const Kernel::Segment_3& segment, const TriangleMesh& mesh, std::uint32_t f)
{
    const TriangleMesh::Face& face = mesh.faces[f];
    const Kernel::Triangle_3 triangle(cgal_point(mesh.corner(face, 0)), cgal_point(mesh.corner(face, 1)),
                                      cgal_point(mesh.corner(face, 2)));
    return !triangle.is_degenerate() && CGAL::do_intersect(segment, triangle);
}

bool is_odd_along(const FaceTree& tree, const Point3& p, const Vec3& way)
{
    const Kernel::Segment_3 segment(cgal_point(p), cgal_point(p + way));
    bool odd = false;
    tree.for_each_face_in(BoxesOnWay(p, way),
                          [&](std::uint32_t f) { odd ^= meets(segment, tree.mesh(), f); });
    return odd;
}

bool is_enclosed(const FaceTree& tree, const Point3& p, double way_out)
{
    const bool first = is_odd_along(tree, p, way_out * kWaysOut[0]);
    const bool second = is_odd_along(tree, p, way_out * kWaysOut[1]);
    return first == second ? first : is_odd_along(tree, p, way_out * kWaysOut[2]);
}

//! Farther than from any point of the mesh's box to any other.
double way_out(const TriangleMesh& mesh, std::span<const Point3> points)
{
    Box3 box = bounding_box(mesh);
    for (const Point3& p : points)
        box.include(p);
    return 2.0 * box.diagonal();
}

} // namespace

std::vector<std::uint8_t> enclosed_by(const FaceTree& tree, std::span<const Point3> points)
{
    const double length = way_out(tree.mesh(), points);
    std::vector<std::uint8_t> enclosed(points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size()),
                      [&](const tbb::blocked_range<std::size_t>& range)
                      {
                          for (std::size_t i = range.begin(); i < range.end(); ++i)
                              enclosed[i] = is_enclosed(tree, points[i], length) ? 1 : 0;
                      });
    return enclosed;
}

} // namespace voroprobe
