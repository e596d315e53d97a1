#include "mesher/circumcenter.h"

#include <cmath>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace voroprobe
{
namespace
{

// A tetrahedron whose determinant is below this fraction of the product of its three edge lengths is a
// sliver: rounding would cost more than nine of the sixteen digits.
constexpr double kSliverRatio = 1e-7;

Point3 exact_circumcenter(const std::array<Point3, 4>& corners)
{
    using ExactPoint = CGAL::Simple_cartesian<CGAL::Exact_rational>::Point_3;
    const auto exact = [](const Point3& p) { return ExactPoint(p.x, p.y, p.z); };
    const ExactPoint center =
        CGAL::circumcenter(exact(corners[0]), exact(corners[1]), exact(corners[2]), exact(corners[3]));
    return {CGAL::to_double(center.x()), CGAL::to_double(center.y()), CGAL::to_double(center.z())};
}

} // namespace

Point3 circumcenter(const std::array<Point3, 4>& corners)
{
    const Vec3 u = corners[1] - corners[0];
    const Vec3 v = corners[2] - corners[0];
    const Vec3 w = corners[3] - corners[0];
    const double uu = squared_norm(u);
    const double vv = squared_norm(v);
    const double ww = squared_norm(w);
    const Vec3 v_cross_w = cross(v, w);
    const double determinant = dot(u, v_cross_w);
    if (determinant * determinant <= kSliverRatio * kSliverRatio * uu * vv * ww)
        return exact_circumcenter(corners);
    return corners[0] + (uu * v_cross_w + vv * cross(w, u) + ww * cross(u, v)) / (2.0 * determinant);
}

} // namespace voroprobe
