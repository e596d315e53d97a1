#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace voroprobe
{

namespace
{

//! An angle that equals a bound is computed a few units in the last place to either side of it.
constexpr double kAngleRoundingDeg = 1e-9;

//! Angle between two directions, degrees. atan2 of sine and cosine keeps its digits for angles near 0 and
//! 180, where acos of a scalar product loses half of them. Source: Kahan 2006, "How futile are mindless
//! assessments of roundoff".
//! Zero where a direction is.
double angle_deg(const Vec3& u, const Vec3& v)
{
    if (u == Vec3{} || v == Vec3{})
        return 0.0;
    return std::atan2(norm(cross(u, v)), dot(u, v)) * 180.0 / std::numbers::pi;
}

//! A bound on angles, held against them mostly by their tangents.
class AngleBound
{
public:
    explicit AngleBound(double bound_deg)
        : bound_deg_(bound_deg - kAngleRoundingDeg), squared_tangents_{squared_tangent(bound_deg - kClearDeg),
                                                                       squared_tangent(bound_deg + kClearDeg)}
    {
    }

    //! Whether the angle between two directions is below the bound.
    [[nodiscard]] bool is_above_angle(const Vec3& u, const Vec3& v) const
    {
        const double cosine = dot(u, v);
        const double squared_sine = squared_norm(cross(u, v)); // both times the same lengths
        const double squared_cosine = cosine * cosine;
        if (cosine < 0.0 && bound_deg_ < 89.0)
            return false;
        if (cosine > 0.0 && squared_sine < squared_tangents_[0] * squared_cosine)
            return true;
        if (cosine > 0.0 && squared_sine > squared_tangents_[1] * squared_cosine)
            return false;
        return angle_deg(u, v) < bound_deg_;
    }

private:
    //! Angles nearer to the bound than this are computed.
    static constexpr double kClearDeg = 1e-6;

    //! Where the tangent does not decide, a number that does not either.
    static double squared_tangent(double angle_deg)
    {
        if (!(angle_deg > 0.0 && angle_deg < 89.0))
            return std::numeric_limits<double>::quiet_NaN();
        const double tangent = std::tan(angle_deg * std::numbers::pi / 180.0);
        return tangent * tangent;
    }

    double bound_deg_;
    std::array<double, 2>
        squared_tangents_; //!< of an angle clearly below the bound, and of one clearly above
};

std::array<double, 3> face_angles_deg(const TriangleMesh& mesh, const TriangleMesh::Face& face)
{
    return triangle_angles_deg(mesh.corner(face, 0), mesh.corner(face, 1), mesh.corner(face, 2));
}

} // namespace

double area(const TriangleMesh& mesh)
{
    double twice_area = 0.0;
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const Point3 a = mesh.corner(face, 0);
        twice_area += norm(cross(mesh.corner(face, 1) - a, mesh.corner(face, 2) - a));
    }
    return 0.5 * twice_area;
}

double enclosed_volume(const TriangleMesh& mesh)
{
    // Any apex gives the same sum; one near the mesh keeps the terms, and so their rounding, small.
    const Point3 apex = bounding_box(mesh).center();
    double six_volume = 0.0;
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const Vec3 a = mesh.corner(face, 0) - apex;
        const Vec3 b = mesh.corner(face, 1) - apex;
        const Vec3 c = mesh.corner(face, 2) - apex;
        six_volume += dot(a, cross(b, c));
    }
    return six_volume / 6.0;
}

std::array<double, 3> triangle_angles_deg(const Point3& a, const Point3& b, const Point3& c)
{
    return {angle_deg(b - a, c - a), angle_deg(c - b, a - b), angle_deg(a - c, b - c)};
}

AngleMeasures measure_angles(const TriangleMesh& mesh)
{
    if (mesh.faces.empty())
        return {};

    AngleMeasures measures{.min_deg = 180.0};
    double sum_of_min_deg = 0.0;
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const auto angles = face_angles_deg(mesh, face);
        const auto [min_deg, max_deg] = std::minmax_element(angles.begin(), angles.end());
        measures.min_deg = std::min(measures.min_deg, *min_deg);
        measures.max_deg = std::max(measures.max_deg, *max_deg);
        sum_of_min_deg += *min_deg;
    }
    measures.mean_min_deg = sum_of_min_deg / static_cast<double>(mesh.faces.size());
    return measures;
}

std::size_t count_faces_below_angle(const TriangleMesh& mesh, double bound_deg)
{
    const AngleBound bound(bound_deg);
    return static_cast<std::size_t>(std::count_if(mesh.faces.begin(), mesh.faces.end(),
                                                  [&](const TriangleMesh::Face& face)
                                                  {
                                                      const Point3 a = mesh.corner(face, 0);
                                                      const Point3 b = mesh.corner(face, 1);
                                                      const Point3 c = mesh.corner(face, 2);
                                                      return bound.is_above_angle(b - a, c - a) ||
                                                             bound.is_above_angle(c - b, a - b) ||
                                                             bound.is_above_angle(a - c, b - c);
                                                  }));
}

} // namespace voroprobe
