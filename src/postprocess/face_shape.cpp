#include "postprocess/face_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace voroprobe
{

double smallest_angle_deg(const Point3& a, const Point3& b, const Point3& c)
{
    const double twice_area = norm(cross(b - a, c - a));
    // The smallest angle is opposite the shortest side: at the corner whose two sides have the largest scalar
    // product.
    const double largest_product = std::max({dot(b - a, c - a), dot(c - b, a - b), dot(a - c, b - c)});
    return twice_area > 0.0 ? std::atan2(twice_area, largest_product) * 180.0 / std::numbers::pi : 0.0;
}

Vec3 unit_normal(const Point3& a, const Point3& b, const Point3& c)
{
    return normalized(cross(b - a, c - a));
}

} // namespace voroprobe
