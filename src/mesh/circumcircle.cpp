#include "mesh/circumcircle.h"

namespace voroprobe
{

std::optional<Circumcircle> circumcircle(const Point3& a, const Point3& b, const Point3& c)
{
    const Vec3 to_b = b - a;
    const Vec3 to_c = c - a;
    const Vec3 normal = cross(to_b, to_c);
    if (!(squared_norm(normal) > 0.0))
        return std::nullopt;
    const Vec3 to_center =
        (squared_norm(to_b) * cross(to_c, normal) + squared_norm(to_c) * cross(normal, to_b)) /
        (2.0 * squared_norm(normal));
    return Circumcircle{a + to_center, normalized(normal), norm(to_center)};
}

} // namespace voroprobe
