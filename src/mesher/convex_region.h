#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/box3.h"
#include "geometry/vec3.h"
#include "mesher/meshing_options.h"

namespace voroprobe
{

//! All points x with dot(normal, x) <= offset.
struct HalfSpace
{
    Vec3 normal;
    double offset;
};

//! What probe() covers: a Voronoi cell clipped to the domain, or the domain itself. A convex polytope, cut by
//! a ball where the domain is one. Coordinates are relative to `origin`, so that a small cell far from the
//! world's origin loses no digits.
struct ConvexRegion
{
    Point3 origin;
    std::vector<HalfSpace> half_spaces;
    std::vector<Point3> corners; //!< of the polytope, the ball left out
    std::optional<Ball> ball;    //!< of the domain
    Point3 hub;                  //!< a point known to be connected to the Voronoi edges or to the outside
};

//! The domain Omega: the oracle's box, or a ball.
struct ProbedDomain
{
    Box3 box; //!< of the ball where there is one
    std::optional<Ball> ball;

    [[nodiscard]] bool contains(const Point3& p) const
    {
        return box.contains(p) && (!ball || squared_distance(p, ball->center) <= ball->radius * ball->radius);
    }
};

//! The whole domain; its hub lies on its boundary. Replaces `region`.
void make_domain_region(const ProbedDomain& domain, ConvexRegion& region);

//! The twelve edges of a box.
std::array<Segment3, 12> edges_of(const Box3& box);

//! Appends the six half-spaces of a box, relative to `region.origin`.
void append_box(const Box3& box, ConvexRegion& region);

//! A box in any orientation around a region: the orthonormal `axis`, the last one along the longest side, and
//! the range of the coordinates dot(axis[k], x) of the region's points.
struct ThinBox
{
    std::array<Vec3, 3> axis;
    Vec3 low;
    Vec3 high;

    [[nodiscard]] Vec3 size() const { return high - low; }
    //! The point, relative to the region's origin, with these coordinates along the axes.
    [[nodiscard]] Vec3 at(const Vec3& c) const { return c.x * axis[0] + c.y * axis[1] + c.z * axis[2]; }
};

//! A bounding box of the corners whose smallest face, over a few directions, has the least area: as few and
//! as long probes as can be. \pre At least one corner. Cost: O(corners).
ThinBox thin_bounding_box(const std::vector<Point3>& corners);

//! The point farthest from another; the first of several. \pre At least one point.
const Point3& farthest_from(const std::vector<Point3>& points, const Point3& from);

//! Two unit vectors that span the plane orthogonal to the unit vector `normal`.
std::array<Vec3, 2> orthonormal_basis(const Vec3& normal);

} // namespace voroprobe
