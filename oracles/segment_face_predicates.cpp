// This file follows:
// Herbert Edelsbrunner and Ernst Peter Muecke, Simulation of simplicity, 1990; here one translation of all
// query points is perturbation enough.

#include "oracles/segment_face_predicates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <CGAL/Exact_rational.h>

namespace voroprobe
{
namespace
{

using Point = MeshKernel::Point_3;
using Triangle = MeshKernel::Triangle_3;
using Number = CGAL::Exact_rational;
using ExactVector = std::array<Number, 3>;

//! Rounding of a product with a face's normal, relative to the three lengths it is made of; generous.
constexpr double kPlaneRounding = 1e-14;

//! Beyond this share of rounding in it, a difference is computed exactly.
constexpr double kTrustedRounding = 1e-10;

ExactVector exact_difference(const Point& to, const Point& from)
{
    return {Number(to.x()) - Number(from.x()), Number(to.y()) - Number(from.y()),
            Number(to.z()) - Number(from.z())};
}

ExactVector exact_cross(const ExactVector& a, const ExactVector& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Number exact_dot(const ExactVector& a, const ExactVector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

ExactVector exact_normal(const Triangle& face)
{
    return exact_cross(exact_difference(face[1], face[0]), exact_difference(face[2], face[0]));
}

//! The sign of the scalar product with (h, h^2, h^3).
CGAL::Sign sign_along_perturbation(const ExactVector& v)
{
    for (const Number& component : v)
        if (const CGAL::Sign sign = CGAL::sign(component); sign != CGAL::ZERO)
            return sign;
    return CGAL::ZERO;
}

//! The side of the face's plane the moved point lies on; zero only for faces without area.
CGAL::Sign side_of_plane(const Triangle& face, const Point& p)
{
    const CGAL::Sign side = CGAL::orientation(face[0], face[1], face[2], p);
    return side != CGAL::ZERO ? side : sign_along_perturbation(exact_normal(face));
}

//! How the moved line passes the line of an edge. As det(t - s, a - s, b - s) is linear in a common move of s
//! and t, with the gradient (t - s) x (b - a), it is zero only where the two are parallel.
CGAL::Sign side_of_edge(const Point& s, const Point& t, const Point& a, const Point& b)
{
    const CGAL::Sign side = CGAL::orientation(s, t, a, b);
    if (side != CGAL::ZERO)
        return side;
    return sign_along_perturbation(exact_cross(exact_difference(t, s), exact_difference(b, a)));
}

} // namespace

// A line parallel to an edge does not pass the plane of the face, so the edges are asked only where they have
// an answer.
bool crosses(const Point& source, const Point& target, const Triangle& face)
{
    const CGAL::Sign from = side_of_plane(face, source);
    if (from == CGAL::ZERO || from == side_of_plane(face, target))
        return false;
    const CGAL::Sign first = side_of_edge(source, target, face[0], face[1]);
    return first == side_of_edge(source, target, face[1], face[2]) &&
           first == side_of_edge(source, target, face[2], face[0]);
}

double crossing_parameter(const Point& source, const Point& target, const Triangle& face)
{
    const auto edge = face[1] - face[0];
    const auto other_edge = face[2] - face[0];
    const auto normal = CGAL::cross_product(edge, other_edge);
    const double from = normal * (source - face[0]);
    const double to = normal * (target - face[0]);
    const double lengths = (source - face[0]).squared_length() + (target - face[0]).squared_length();
    const double rounding =
        kPlaneRounding * std::sqrt(edge.squared_length() * other_edge.squared_length() * lengths);
    if (rounding <= kTrustedRounding * std::abs(from - to))
        return std::clamp(from / (from - to), 0.0, 1.0);

    const ExactVector n = exact_normal(face);
    const Number exact_from = exact_dot(n, exact_difference(source, face[0]));
    const Number exact_to = exact_dot(n, exact_difference(target, face[0]));
    if (exact_from == exact_to) // both in the plane: it is crossed by the perturbation alone
        return 0.5;
    return std::clamp(CGAL::to_double(Number(exact_from / (exact_from - exact_to))), 0.0, 1.0);
}

} // namespace voroprobe
