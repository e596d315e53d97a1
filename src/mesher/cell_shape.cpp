#include "mesher/cell_shape.h"

#include <algorithm>
#include <cmath>

namespace voroprobe
{

double longest_edge(const Tetrahedron& p)
{
    double longest = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
            longest = std::max(longest, squared_distance(p[i], p[j]));
    return std::sqrt(longest);
}

double least_altitude(const Tetrahedron& p)
{
    const double six_volumes = std::abs(dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0])));
    double largest_two_areas = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
    {
        const Point3& a = p[(i + 1) % 4];
        largest_two_areas = std::max(largest_two_areas, norm(cross(p[(i + 2) % 4] - a, p[(i + 3) % 4] - a)));
    }
    return largest_two_areas > 0.0 ? six_volumes / largest_two_areas : 0.0;
}

} // namespace voroprobe
