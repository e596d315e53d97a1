#include "mesher/voronoi_cell.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace voroprobe
{
namespace
{

// Points this near to a side of the domain, in its diagonals, lie on it: above rounding.
constexpr double kOnSideInDiagonals = 1e-9;
constexpr std::uint32_t kNoPlace = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kFirstSlots = 64; // a power of two
// The hash table of a star is at most half full.
constexpr std::size_t kSlotsPerCell = 2;

//! Where a cell lies in memory, without the bits that most have in common.
std::size_t hash_of(DelaunayCell delaunay_cell)
{
    return reinterpret_cast<std::uintptr_t>(&*delaunay_cell) / sizeof(*delaunay_cell);
}

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

void append_ends(const Segment3& segment, const ParameterRange& range, ConvexRegion& region)
{
    region.corners.push_back(segment.at(range.first) - region.origin);
    region.corners.push_back(segment.at(range.second) - region.origin);
}

//! Ends of the box's edges' parts in the region's half-spaces.
void append_box_edges(const Box3& box, ConvexRegion& region)
{
    for (const Segment3& edge : edges_of(box))
    {
        const Segment3 relative{edge.source - region.origin, edge.target - region.origin};
        if (const auto range = clip_to(region.half_spaces, relative))
            append_ends(edge, *range, region);
    }
}

} // namespace

VoronoiCell::VoronoiCell() : places_(kFirstSlots, kNoPlace) {}

// CGAL's incident_cells() marks cells while it walks, which only one thread at a time may do.
void VoronoiCell::assign(VertexHandle vertex)
{
    vertex_ = vertex;
    star_.clear();
    corners_.clear();
    edges_.clear();
    places_.assign(kFirstSlots, kNoPlace); // a large cell before would make every later one slow
    place_in_star(vertex->cell());
    for (std::uint32_t c = 0; c < star_.size(); ++c)
    {
        const DelaunayCell delaunay_cell = star_[c];
        corners_.push_back(delaunay_cell->info().circumcenter);
        const int own = delaunay_cell->index(vertex);
        for (int step = 1; step < 4; ++step)
        {
            const std::uint32_t other = place_in_star(delaunay_cell->neighbor((own + step) % 4));
            if (c < other) // each edge from one end
                edges_.push_back({c, other});
        }
    }
}

// Appends the cell where it is not in the star yet.
std::uint32_t VoronoiCell::place_in_star(DelaunayCell delaunay_cell)
{
    const std::size_t slot_mask = places_.size() - 1;
    std::size_t slot = hash_of(delaunay_cell) & slot_mask;
    while (places_[slot] != kNoPlace && star_[places_[slot]] != delaunay_cell)
        slot = (slot + 1) & slot_mask;
    if (places_[slot] != kNoPlace)
        return places_[slot];
    prefetch(delaunay_cell);
    const auto place = static_cast<std::uint32_t>(star_.size());
    places_[slot] = place;
    star_.push_back(delaunay_cell);
    if (kSlotsPerCell * star_.size() > places_.size())
        grow_places();
    return place;
}

void VoronoiCell::grow_places()
{
    places_.assign(2 * places_.size(), kNoPlace);
    for (std::uint32_t c = 0; c < star_.size(); ++c)
    {
        std::size_t slot = hash_of(star_[c]) & (places_.size() - 1);
        while (places_[slot] != kNoPlace)
            slot = (slot + 1) & (places_.size() - 1);
        places_[slot] = c;
    }
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
        append_edges_in(domain.box, region);
        append_box_edges(domain.box, region);
        append_box(domain.box, region);
    }
    if (!region.corners.empty()) // each is on a Voronoi edge or on the domain's boundary
        region.hub =
            *std::min_element(region.corners.begin(), region.corners.end(),
                              [](const Vec3& a, const Vec3& b) { return squared_norm(a) < squared_norm(b); });
}

void VoronoiCell::outline(const ProbedDomain& domain, ConvexOutline& outline) const
{
    outline.bounds = domain.box;
    outline.origin = site();
    outline.corners.clear();
    for (const Point3& corner : corners_)
        outline.corners.push_back(corner - outline.origin);
    outline.edges = edges_;
}

void VoronoiCell::clipped_outline(const ProbedDomain& domain, ConvexOutline& outline) const
{
    if (is_within({domain.box, std::nullopt}))
        return this->outline(domain, outline);
    outline.bounds = domain.box;
    outline.origin = site();
    outline.corners.clear();
    outline.edges.clear();
    append_clipped_outline(domain, outline);
}

// The Voronoi edges' parts in the domain, and on each side of the domain the segments between all points
// where edges of either leave it.
void VoronoiCell::append_clipped_outline(const ProbedDomain& domain, ConvexOutline& outline) const
{
    ConvexRegion region;
    region.origin = outline.origin;
    append_edges_in(domain.box, region);
    if (may_meet_edges_of(domain.box))
    {
        append_bisectors(region);
        append_box_edges(domain.box, region);
    }
    for (std::size_t c = 0; c + 1 < region.corners.size(); c += 2)
        outline.add({region.corners[c], region.corners[c + 1]});
    const double rounding = kOnSideInDiagonals * domain.box.diagonal();
    std::vector<Point3> on_side;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        for (const double side : {domain.box.min[axis], domain.box.max[axis]})
        {
            on_side.clear();
            for (const Point3& corner : region.corners)
            {
                if (std::abs(corner[axis] + outline.origin[axis] - side) <= rounding)
                    on_side.push_back(corner);
            }
            for (std::size_t a = 0; a < on_side.size(); ++a)
                for (std::size_t b = 0; b < a; ++b)
                    outline.add({on_side[a], on_side[b]});
        }
    }
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

// Ends of the Voronoi edges' parts in the box.
void VoronoiCell::append_edges_in(const Box3& box, ConvexRegion& region) const
{
    for (const OutlineEdge& voronoi_edge : edges_)
    {
        const Segment3 edge{corners_[voronoi_edge.from], corners_[voronoi_edge.to]};
        if (const auto range = clip_to_box(edge, box))
            append_ends(edge, *range, region);
    }
}

// Whether an edge of a box that holds the site may pass through the cell. It does not where the cell's
// section with the plane of each side lies within that side; the corners of the section are on Voronoi edges.
bool VoronoiCell::may_meet_edges_of(const Box3& box) const
{
    const double rounding = kOnSideInDiagonals * box.diagonal();
    const Box3 within{box.min + Vec3{rounding, rounding, rounding},
                      box.max - Vec3{rounding, rounding, rounding}};
    for (const OutlineEdge& voronoi_edge : edges_)
    {
        const Segment3 edge{corners_[voronoi_edge.from], corners_[voronoi_edge.to]};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            for (const double side : {box.min[axis], box.max[axis]})
            {
                const double from = edge.source[axis] - side;
                const double to = edge.target[axis] - side;
                if ((from < 0.0) == (to < 0.0))
                    continue;
                Point3 at = edge.at(from / (from - to));
                at[axis] = box.center()[axis];
                if (!within.contains(at))
                    return true;
            }
        }
    }
    return false;
}

} // namespace voroprobe
