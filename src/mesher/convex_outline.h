#pragma once

#include <cstdint>
#include <vector>

#include "mesher/convex_region.h"

namespace voroprobe
{

//! What of a region lies between two planes across an axis through its origin.
struct Slab
{
    double low;
    double high;
};

//! Between two corners, by their places.
struct OutlineEdge
{
    std::uint32_t from;
    std::uint32_t to;
};

//! A convex region by segments whose parts between any two parallel planes span the region's part there: its
//! edges, and diagonals of its sides perhaps. Every segment is probed, on the domain's boundary or beyond it.
//! Lengths are relative to `origin`.
struct ConvexOutline
{
    Box3 bounds;               //!< of the domain: what the region has beyond is not asked for
    Point3 origin;             //!< for a Voronoi cell its site
    std::vector<Vec3> corners; //!< the ends of the edges, once or more often
    std::vector<OutlineEdge> edges;

    //! Adds an edge and its ends.
    void add(const Segment3& segment);
};

//! The domain's.
ConvexOutline domain_outline(const ProbedDomain& domain);

//! Corners of the outline's part in a slab: they span it. `heights`: of the outline's corners along the axis
//! that the slab is across. Replaces `points`.
void collect_points(const ConvexOutline& outline, const std::vector<double>& heights, const Slab& slab,
                    std::vector<Vec3>& points);

} // namespace voroprobe
