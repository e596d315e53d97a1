#include "mesher/convex_outline.h"

namespace voroprobe
{
void ConvexOutline::add(const Segment3& segment)
{
    const auto from = static_cast<std::uint32_t>(corners.size());
    corners.push_back(segment.source);
    corners.push_back(segment.target);
    edges.push_back({from, from + 1});
}

ConvexOutline domain_outline(const ProbedDomain& domain)
{
    ConvexOutline outline{domain.box, domain.box.center(), {}, {}};
    for (const Segment3& edge : edges_of(domain.box))
        outline.add({edge.source - outline.origin, edge.target - outline.origin});
    return outline;
}

void collect_points(const ConvexOutline& outline, const std::vector<double>& heights, const Slab& slab,
                    std::vector<Vec3>& points)
{
    points.clear();
    for (std::size_t c = 0; c < heights.size(); ++c)
    {
        if (slab.low <= heights[c] && heights[c] <= slab.high)
            points.push_back(outline.corners[c]);
    }
    for (const OutlineEdge& edge : outline.edges)
    {
        const double from = heights[edge.from];
        const double to = heights[edge.to];
        for (const double height : {slab.low, slab.high})
        {
            if ((from < height) != (to < height))
                points.push_back(Segment3{outline.corners[edge.from], outline.corners[edge.to]}.at(
                    (height - from) / (to - from)));
        }
    }
}

} // namespace voroprobe
