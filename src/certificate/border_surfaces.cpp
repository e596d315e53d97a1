#include "certificate/border_surfaces.h"

#include <algorithm>
#include <span>
#include <vector>

namespace voroprobe
{
namespace
{

//! Points looked at: more than a surface so small has.
constexpr std::size_t kMostPoints = 1000;

double depth(const Point3& p, const Box3& domain)
{
    double least = domain.diagonal();
    for (std::size_t axis = 0; axis < 3; ++axis)
        least = std::min({least, p[axis] - domain.min[axis], domain.max[axis] - p[axis]});
    return least;
}

} // namespace

bool lies_in_border(const SurfaceOracle& oracle, SurfaceId surface, double floor_radius)
{
    const Box3 domain = oracle.domain();
    const std::vector<std::vector<Point3>> points = oracle.points_on(std::span(&surface, 1), kMostPoints);
    return !points.front().empty() &&
           std::all_of(points.front().begin(), points.front().end(),
                       [&](const Point3& p) { return depth(p, domain) < 2.0 * floor_radius; });
}

} // namespace voroprobe
