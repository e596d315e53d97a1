#include "mesher/convex_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace voroprobe
{
namespace
{

// Directions tried for the shorter sides of a box, over a quarter turn.
constexpr int kTurns = 6;

struct Range
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    [[nodiscard]] double length() const { return high - low; }
};

Range range_along(const std::vector<Point3>& points, const Vec3& direction)
{
    Range range;
    for (const Point3& p : points)
    {
        const double along = dot(p, direction);
        range.low = std::min(range.low, along);
        range.high = std::max(range.high, along);
    }
    return range;
}

//! The box around the points with its last axis along `w` and the thinnest of a few turns around it.
ThinBox box_along(const std::vector<Point3>& points, const Vec3& w)
{
    const auto [a, b] = orthonormal_basis(w);
    const Range along_w = range_along(points, w);
    ThinBox best;
    double least_area = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < kTurns; ++turn)
    {
        const double angle = turn * std::numbers::pi / (2 * kTurns);
        const Vec3 u = std::cos(angle) * a + std::sin(angle) * b;
        const Vec3 v = cross(w, u);
        const Range along_u = range_along(points, u);
        const Range along_v = range_along(points, v);
        const double area = along_u.length() * along_v.length();
        if (area < least_area)
        {
            least_area = area;
            best = {{u, v, w},
                    {along_u.low, along_v.low, along_w.low},
                    {along_u.high, along_v.high, along_w.high}};
        }
    }
    return best;
}

//! The same box with its longest side last.
ThinBox longest_last(ThinBox box)
{
    const Vec3 size = box.size();
    const std::size_t longest = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    if (longest != 2)
    {
        std::swap(box.axis[longest], box.axis[2]);
        std::swap(box.low[longest], box.low[2]);
        std::swap(box.high[longest], box.high[2]);
    }
    return box;
}

double smallest_face(const ThinBox& box)
{
    return box.size().x * box.size().y;
}

} // namespace

std::array<Segment3, 12> edges_of(const Box3& box)
{
    std::array<Segment3, 12> edges;
    std::size_t count = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        for (unsigned side = 0; side < 4; ++side)
        {
            Point3 source = box.min;
            if ((side & 1U) != 0)
                source[(axis + 1) % 3] = box.max[(axis + 1) % 3];
            if ((side & 2U) != 0)
                source[(axis + 2) % 3] = box.max[(axis + 2) % 3];
            Point3 target = source;
            target[axis] = box.max[axis];
            edges[count++] = {source, target};
        }
    }
    return edges;
}

void append_box(const Box3& box, ConvexRegion& region)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        Vec3 normal;
        normal[axis] = 1.0;
        region.half_spaces.push_back({normal, box.max[axis] - region.origin[axis]});
        region.half_spaces.push_back({-normal, region.origin[axis] - box.min[axis]});
    }
}

void make_domain_region(const ProbedDomain& domain, ConvexRegion& region)
{
    region = ConvexRegion{};
    region.origin = domain.box.center();
    region.ball = domain.ball;
    append_box(domain.box, region);
    const Vec3 half = 0.5 * domain.box.extent();
    for (const double x : {-half.x, half.x})
        for (const double y : {-half.y, half.y})
            for (const double z : {-half.z, half.z})
                region.corners.push_back({x, y, z});
    region.hub = region.corners.front();
}

ThinBox thin_bounding_box(const std::vector<Point3>& corners)
{
    const Point3& one_end = farthest_from(corners, corners.front());
    const Vec3 diameter = farthest_from(corners, one_end) - one_end;
    ThinBox best = longest_last(box_along(corners, {1, 0, 0})); // turned by nothing: aligned with the axes
    if (diameter == Vec3{})
        return best;
    for (const Vec3& w : {normalized(diameter), Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    {
        const ThinBox box = longest_last(box_along(corners, w));
        if (smallest_face(box) < smallest_face(best))
            best = box;
    }
    return best;
}

const Point3& farthest_from(const std::vector<Point3>& points, const Point3& from)
{
    const Point3* farthest = points.data();
    double squared = squared_distance(*farthest, from);
    for (const Point3& p : points)
    {
        const double other = squared_distance(p, from);
        if (other > squared)
        {
            squared = other;
            farthest = &p;
        }
    }
    return *farthest;
}

std::array<Vec3, 2> orthonormal_basis(const Vec3& normal)
{
    const Vec3 size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
    const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3{1, 0, 0}
                      : size.y <= size.z                   ? Vec3{0, 1, 0}
                                                           : Vec3{0, 0, 1};
    const Vec3 a = normalized(cross(normal, axis));
    return {a, cross(normal, a)};
}

} // namespace voroprobe
