#pragma once

#include <array>

#include "geometry/vec3.h"

namespace voroprobe
{

//! 3x3 matrix by columns: `column[a]` is the image of unit vector a.
struct Matrix3
{
    std::array<Vec3, 3> column{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

    friend constexpr Vec3 operator*(const Matrix3& m, const Vec3& v)
    {
        return v.x * m.column[0] + v.y * m.column[1] + v.z * m.column[2];
    }
    friend constexpr Matrix3 operator*(const Matrix3& a, const Matrix3& b)
    {
        return {{a * b.column[0], a * b.column[1], a * b.column[2]}};
    }
    friend constexpr bool operator==(const Matrix3&, const Matrix3&) = default;
};

constexpr double determinant(const Matrix3& m)
{
    return dot(m.column[0], cross(m.column[1], m.column[2]));
}

//! Inverse of a matrix with determinant != 0.
constexpr Matrix3 inverse(const Matrix3& m)
{
    const double d = determinant(m);
    const Vec3 r0 = cross(m.column[1], m.column[2]) / d;
    const Vec3 r1 = cross(m.column[2], m.column[0]) / d;
    const Vec3 r2 = cross(m.column[0], m.column[1]) / d;
    return {{Vec3{r0.x, r1.x, r2.x}, Vec3{r0.y, r1.y, r2.y}, Vec3{r0.z, r1.z, r2.z}}};
}

//! p_to = linear * p_from + translation. Named destination first: `world_from_grid`.
struct AffineTransform
{
    Matrix3 linear;
    Vec3 translation;

    friend constexpr Point3 operator*(const AffineTransform& t, const Point3& p)
    {
        return t.linear * p + t.translation;
    }
    friend constexpr AffineTransform operator*(const AffineTransform& a, const AffineTransform& b)
    {
        return {a.linear * b.linear, a * b.translation};
    }
    friend constexpr bool operator==(const AffineTransform&, const AffineTransform&) = default;
};

constexpr AffineTransform inverse(const AffineTransform& t)
{
    const Matrix3 linear = inverse(t.linear);
    return {linear, -(linear * t.translation)};
}

} // namespace voroprobe
