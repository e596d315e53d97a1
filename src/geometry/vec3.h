#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace voroprobe
{

//! A vector or, under its other name, a point of 3D space. Frame and unit are told by the name of the
//! variable.
struct Vec3
{
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;

    constexpr double operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    constexpr double& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }

    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
    friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b)
    {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b)
    {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
    friend constexpr Vec3 operator*(const Vec3& a, double s) { return s * a; }
    friend constexpr Vec3 operator/(const Vec3& a, double s) { return {a.x / s, a.y / s, a.z / s}; }
    constexpr Vec3& operator+=(const Vec3& b) { return *this = *this + b; }
    constexpr Vec3& operator-=(const Vec3& b) { return *this = *this - b; }
};

using Point3 = Vec3;

constexpr double dot(const Vec3& a, const Vec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

constexpr Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

constexpr double squared_norm(const Vec3& a)
{
    return dot(a, a);
}

inline double norm(const Vec3& a)
{
    return std::sqrt(squared_norm(a));
}

constexpr double squared_distance(const Point3& a, const Point3& b)
{
    return squared_norm(b - a);
}

inline double distance(const Point3& a, const Point3& b)
{
    return norm(b - a);
}

//! Unit vector along `a`; the zero vector stays zero.
inline Vec3 normalized(const Vec3& a)
{
    const double length = norm(a);
    return length > 0.0 ? a / length : a;
}

inline bool is_finite(const Vec3& a)
{
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

} // namespace voroprobe
