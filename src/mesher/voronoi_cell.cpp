#include "mesher/voronoi_cell.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace voroprobe
{
namespace
{

//! The part of the segment in all half-spaces; nullopt where there is none.
std::optional<ParameterRange> clip_to(const std::vector<HalfSpace>& half_spaces, const Segment3& segment)
{
    ParameterRange range{0.0, 1.0};
    for (const HalfSpace& half_space : half_spaces)
    {
        const double from = dot(half_space.normal, segment.source) - half_space.offset;
        const double to = dot(half_space.normal, segment.target) - half_space.offset;
        if (from > 0.0 && to > 0.0)
            return std::nullopt;
        if (from > 0.0)
            range.first = std::max(range.first, from / (from - to));
        else if (to > 0.0)
            range.second = std::min(range.second, from / (from - to));
    }
    return range.first <= range.second ? std::optional(range) : std::nullopt;
}

//! The twelve edges of a box.
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

} // namespace

void VoronoiCell::assign(const RestrictedDelaunay& restricted, VertexHandle vertex)
{
    vertex_ = vertex;
    star_.clear();
    corners_.clear();
    restricted.triangulation().incident_cells(vertex, std::back_inserter(star_));
    for (const DelaunayCell delaunay_cell : star_)
        corners_.push_back(delaunay_cell->info().circumcenter);
}

double VoronoiCell::size_within(const Box3& domain) const
{
    const Point3 p = site();
    Vec3 to_corner;
    for (std::size_t axis = 0; axis < 3; ++axis)
        to_corner[axis] = std::max(p[axis] - domain.min[axis], domain.max[axis] - p[axis]);
    return std::sqrt(std::min(squared_distance(farthest_from(corners_, p), p), squared_norm(to_corner)));
}

bool VoronoiCell::is_within(const ProbedDomain& domain) const
{
    return std::all_of(corners_.begin(), corners_.end(),
                       [&](const Point3& corner) { return domain.contains(corner); });
}

Cylinder VoronoiCell::cylinder() const
{
    const Point3 end = farthest_from(corners_, site());
    const Vec3 w = normalized(farthest_from(corners_, end) - end);
    const auto [u, v] = orthonormal_basis(w);
    Vec3 low;
    Vec3 high;
    for (const Point3& corner : corners_)
    {
        const Vec3 x = corner - end;
        const Vec3 along{dot(u, x), dot(v, x), dot(w, x)};
        low = {std::min(low.x, along.x), std::min(low.y, along.y), std::min(low.z, along.z)};
        high = {std::max(high.x, along.x), std::max(high.y, along.y), std::max(high.z, along.z)};
    }
    const Point3 middle = end + 0.5 * (low.x + high.x) * u + 0.5 * (low.y + high.y) * v;
    double squared_radius = 0.0;
    for (const Point3& corner : corners_)
    {
        const Vec3 x = corner - middle;
        const double along = dot(w, x);
        squared_radius = std::max(squared_radius, squared_norm(x) - along * along);
    }
    return {{middle + low.z * w, middle + high.z * w}, std::sqrt(squared_radius)};
}

void VoronoiCell::clip_to(const ProbedDomain& domain, ConvexRegion& region) const
{
    region.origin = site();
    region.half_spaces.clear();
    region.corners.clear();
    region.ball = domain.ball;
    append_bisectors(region);
    if (is_within({domain.box, std::nullopt}))
    {
        for (const Point3& corner : corners_)
            region.corners.push_back(corner - region.origin);
    }
    else
    {
        append_clipped_corners(domain, region);
        append_box(domain.box, region);
    }
    if (!region.corners.empty()) // each is on a Voronoi edge or on the domain's boundary
        region.hub =
            *std::min_element(region.corners.begin(), region.corners.end(),
                              [](const Vec3& a, const Vec3& b) { return squared_norm(a) < squared_norm(b); });
}

// The points as near to the site as to a Delaunay neighbour.
void VoronoiCell::append_bisectors(ConvexRegion& region) const
{
    std::vector<VertexHandle> neighbours;
    neighbours.reserve(4 * star_.size());
    for (const DelaunayCell delaunay_cell : star_)
    {
        for (int i = 0; i < 4; ++i)
        {
            if (delaunay_cell->vertex(i) != vertex_)
                neighbours.push_back(delaunay_cell->vertex(i));
        }
    }
    const auto index = [](VertexHandle vertex) { return vertex->info().index; };
    std::sort(neighbours.begin(), neighbours.end(),
              [&](VertexHandle a, VertexHandle b) { return index(a) < index(b); });
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    for (const VertexHandle neighbour : neighbours)
    {
        const Vec3 normal = position(neighbour) - region.origin;
        region.half_spaces.push_back({normal, 0.5 * squared_norm(normal)});
    }
}

// Ends of the Voronoi edges' parts in the box, and of the box's edges' parts in the Voronoi cell.
void VoronoiCell::append_clipped_corners(const ProbedDomain& domain, ConvexRegion& region) const
{
    const auto append = [&](const Segment3& segment, const ParameterRange& range)
    {
        region.corners.push_back(segment.at(range.first) - region.origin);
        region.corners.push_back(segment.at(range.second) - region.origin);
    };
    for (const DelaunayCell delaunay_cell : star_)
    {
        for (int i = 0; i < 4; ++i)
        {
            const DelaunayCell neighbor = delaunay_cell->neighbor(i);
            if (delaunay_cell->vertex(i) == vertex_)
                continue; // the others are met from both ends, which does no harm
            const Segment3 edge{delaunay_cell->info().circumcenter, neighbor->info().circumcenter};
            if (const auto range = clip_to_box(edge, domain.box))
                append(edge, *range);
        }
    }
    for (const Segment3& edge : edges_of(domain.box))
    {
        const Segment3 relative{edge.source - region.origin, edge.target - region.origin};
        if (const auto range = voroprobe::clip_to(region.half_spaces, relative))
            append(edge, *range);
    }
}

} // namespace voroprobe
