#include "geometry/point_triangle.h"

#include <algorithm>

namespace voroprobe
{
namespace
{

double squared_distance_to_edge(const Point3& p, const Point3& a, const Point3& b)
{
    const Vec3 along = b - a;
    const double squared_length = squared_norm(along);
    const double t = squared_length > 0.0 ? std::clamp(dot(p - a, along) / squared_length, 0.0, 1.0) : 0.0;
    return squared_distance(p, a + t * along);
}

} // namespace

double squared_distance_to_triangle(const Point3& p, const std::array<Point3, 3>& corners)
{
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    bool above = squared_norm(normal) > 0.0; // the foot of the perpendicular lies in the triangle
    for (std::size_t k = 0; k < 3 && above; ++k)
    {
        const Point3& a = corners[k];
        const Point3& b = corners[(k + 1) % 3];
        above = dot(cross(normal, b - a), p - a) >= 0.0;
    }
    if (above)
    {
        const double height = dot(normal, p - corners[0]);
        return height * height / squared_norm(normal);
    }
    return std::min({squared_distance_to_edge(p, corners[0], corners[1]),
                     squared_distance_to_edge(p, corners[1], corners[2]),
                     squared_distance_to_edge(p, corners[2], corners[0])});
}

double squared_circumradius(const std::array<Point3, 3>& corners)
{
    const double aa = squared_distance(corners[1], corners[2]);
    const double bb = squared_distance(corners[2], corners[0]);
    const double cc = squared_distance(corners[0], corners[1]);
    return aa * bb * cc / (4.0 * squared_norm(cross(corners[1] - corners[0], corners[2] - corners[0])));
}

} // namespace voroprobe
