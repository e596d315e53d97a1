#include "mesher/cap_finder.h"

#include <algorithm>

namespace voroprobe
{

std::optional<Crossing> CapFinder::nearest(const Point3& p, const Vec3& direction, double reach)
{
    oracle_.find_crossings({p - reach * direction, p + reach * direction}, crossings_);
    const auto found =
        std::min_element(crossings_.begin(), crossings_.end(),
                         [&](const Crossing& a, const Crossing& b)
                         { return squared_distance(p, a.point) < squared_distance(p, b.point); });
    return found == crossings_.end() ? std::nullopt : std::optional(*found);
}

} // namespace voroprobe
