#include "mesher/circumcenter.h"

#include <algorithm>
#include <cstddef>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace voroprobe
{
namespace
{

// A tetrahedron whose determinant is below this fraction of the product of its three edge lengths is a
// sliver: rounding would cost more digits than the promised nine. The second bound is for 64-bit
// significands.
constexpr double kSliverRatio = 1e-7;
constexpr double kExtendedSliverRatio = 1e-10;

Point3 exact_circumcenter(const std::array<Point3, 4>& corners)
{
    using ExactPoint = CGAL::Simple_cartesian<CGAL::Exact_rational>::Point_3;
    const auto exact = [](const Point3& p) { return ExactPoint(p.x, p.y, p.z); };
    const ExactPoint center =
        CGAL::circumcenter(exact(corners[0]), exact(corners[1]), exact(corners[2]), exact(corners[3]));
    return {CGAL::to_double(center.x()), CGAL::to_double(center.y()), CGAL::to_double(center.z())};
}

//! The circumcenter in the arithmetic of Real; false where the tetrahedron is too flat for it.
template <typename Real>
bool rounded_circumcenter(const std::array<Point3, 4>& corners, Real sliver_ratio, Point3& center)
{
    struct Vector
    {
        Real x, y, z;
        Real squared_norm() const { return x * x + y * y + z * z; }
    };
    const auto from_first = [&](const Point3& p)
    {
        const Point3& o = corners[0];
        return Vector{Real(p.x) - Real(o.x), Real(p.y) - Real(o.y), Real(p.z) - Real(o.z)};
    };
    const auto cross = [](const Vector& a, const Vector& b) {
        return Vector{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    };
    const Vector u = from_first(corners[1]);
    const Vector v = from_first(corners[2]);
    const Vector w = from_first(corners[3]);
    const Real uu = u.squared_norm();
    const Real vv = v.squared_norm();
    const Real ww = w.squared_norm();
    const Vector vw = cross(v, w);
    const Vector wu = cross(w, u);
    const Vector uv = cross(u, v);
    const Real determinant = u.x * vw.x + u.y * vw.y + u.z * vw.z;
    if (determinant * determinant <= sliver_ratio * sliver_ratio * uu * vv * ww)
        return false;
    const Real scale = Real(0.5) / determinant;
    center = corners[0] + Vec3{static_cast<double>(scale * (uu * vw.x + vv * wu.x + ww * uv.x)),
                               static_cast<double>(scale * (uu * vw.y + vv * wu.y + ww * uv.y)),
                               static_cast<double>(scale * (uu * vw.z + vv * wu.z + ww * uv.z))};
    return true;
}

} // namespace

// Seen from a corner far away the others look like one point, so each corner has its turn as the first: with
// sentinels among them most tetrahedra would else be taken for slivers.
Point3 circumcenter(const std::array<Point3, 4>& corners)
{
    Point3 center;
    std::array<Point3, 4> from = corners;
    for (std::size_t turn = 0; turn < from.size(); ++turn)
    {
        if (rounded_circumcenter<double>(from, kSliverRatio, center))
            return center;
        std::rotate(from.begin(), from.begin() + 1, from.end());
    }
    if (rounded_circumcenter<long double>(corners, kExtendedSliverRatio, center))
        return center;
    return exact_circumcenter(corners);
}

} // namespace voroprobe
