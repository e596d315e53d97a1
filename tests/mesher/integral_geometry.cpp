#include "integral_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "support/random.h"

namespace voroprobe
{
namespace
{

//! Direction i of n over half the sphere, each for an equal part of it: the golden spiral.
Vec3 spiral_direction(std::size_t i, std::size_t n)
{
    const double z = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / std::numbers::phi;
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * std::cos(turn), radius * std::sin(turn), z};
}

//! Any unit vector perpendicular to a unit vector.
Vec3 perpendicular(const Vec3& direction)
{
    const Vec3 axis = std::abs(direction.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    return normalized(cross(direction, axis));
}

//! Length of a segment that begins outside, inside.
double inside_length(const std::vector<Crossing>& crossings)
{
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        length += distance(crossings[i].point, crossings[i + 1].point);
    return length;
}

Vec3 unit(std::size_t axis, double length)
{
    Vec3 v{0, 0, 0};
    v[axis] = length;
    return v;
}

} // namespace

SurfaceMeasures measure_with_lines(const SurfaceOracle& oracle, std::size_t directions, std::size_t lines)
{
    const Point3 center = oracle.domain().center();
    const double side = oracle.domain().diagonal(); // of the square that holds the domain's shadow
    const double spacing = side / static_cast<double>(lines);
    Random random(1);
    SurfaceMeasures sum;
    std::vector<Crossing> crossings;
    for (std::size_t d = 0; d < directions; ++d)
    {
        const Vec3 along = spiral_direction(d, directions);
        const Vec3 u = perpendicular(along);
        const Vec3 v = cross(along, u);
        const double shift_u = random.uniform() - 0.5 * static_cast<double>(lines);
        const double shift_v = random.uniform() - 0.5 * static_cast<double>(lines);
        for (std::size_t i = 0; i < lines * lines; ++i)
        {
            const Point3 p = center + (spacing * (static_cast<double>(i % lines) + shift_u)) * u +
                             (spacing * (static_cast<double>(i / lines) + shift_v)) * v;
            oracle.find_crossings({p - side * along, p + side * along}, crossings);
            sum.area += 2.0 * static_cast<double>(crossings.size());
            sum.volume += inside_length(crossings);
        }
    }
    const double weight = spacing * spacing / static_cast<double>(directions);
    return {weight * sum.area, weight * sum.volume};
}

double largest_curvature(const std::function<double(const Point3&)>& function,
                         const std::vector<Point3>& points, double step)
{
    double largest = 0.0;
    for (const Point3& p : points)
    {
        Vec3 gradient{0, 0, 0};
        for (std::size_t i = 0; i < 3; ++i)
            gradient[i] = (function(p + unit(i, step)) - function(p - unit(i, step))) / (2.0 * step);
        const Vec3 normal = normalized(gradient);
        const Vec3 u = perpendicular(normal);
        const std::array<Vec3, 2> tangent{step * u, step * cross(normal, u)};

        double squared = 0.0; // of the second derivative in the tangent plane
        for (const Vec3& s : tangent)
            for (const Vec3& t : tangent)
            {
                const double second =
                    (function(p + s + t) - function(p + s - t) - function(p - s + t) + function(p - s - t)) /
                    (4.0 * step * step);
                squared += second * second;
            }
        largest = std::max(largest, std::sqrt(squared) / norm(gradient));
    }
    return largest;
}

} // namespace voroprobe
