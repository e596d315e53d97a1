#include "mesher/slab_probing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

// Half the thickness of the slab around the site, in reaches: the box of what lies beyond a tilted slab has
// to clear the surface in the middle.
constexpr double kNearSlab = 3.0;
// Slabs are not cut shorter than this, in reaches.
constexpr double kShortestSlab = 2.0 * kNearSlab;
// Boxes of up to so many tiles get the paper's probes at once, wider ones are searched for what may hold
// surface.
constexpr std::size_t kFewTiles = 12;
// Largest number of leaves along a side: wider boxes than this would take hours.
constexpr double kMostLeaves = 1U << 20U;

Vec3 coordinates_along(const std::array<Vec3, 3>& axis, const Vec3& x)
{
    return {dot(axis[0], x), dot(axis[1], x), dot(axis[2], x)};
}

} // namespace

//! Probes along a cylinder around its axis, evenly, and one on it perhaps: as disks that cover a disk.
struct ProbeRing
{
    std::size_t around;
    bool on_axis;
    std::size_t queries; //!< with those that join them

    //! Radius of the disks of a ring that covers a disk of radius 1: they stand on the sides of the polygon
    //! inscribed into it.
    [[nodiscard]] double disk_radius() const
    {
        return std::sin(std::numbers::pi / static_cast<double>(around));
    }
    [[nodiscard]] double ring_radius() const
    {
        return std::cos(std::numbers::pi / static_cast<double>(around));
    }
};

namespace
{

constexpr std::array<ProbeRing, 3> kProbeRings{{{3, false, 6}, {4, false, 7}, {6, true, 11}}};

//! The first ring of reach-wide disks that covers a disk.
const ProbeRing* ring_for(double disk_radius, double reach)
{
    const auto ring =
        std::find_if(kProbeRings.begin(), kProbeRings.end(),
                     [&](const ProbeRing& candidate)
                     { return disk_radius * candidate.disk_radius() <= kTileHalfDiagonal * reach; });
    return ring == kProbeRings.end() ? nullptr : &*ring;
}

} // namespace

ConvexOutline domain_outline(const ProbedDomain& domain)
{
    ConvexOutline outline{domain.box.center(), {}};
    for (const Segment3& edge : edges_of(domain.box))
        outline.edges.push_back({edge.source - outline.origin, edge.target - outline.origin});
    return outline;
}

SlabProbing::Outcome SlabProbing::probe(const ConvexOutline& outline, const IsNews& is_news, Effort effort)
{
    is_news_ = &is_news;
    effort_ = effort;
    if (outline.edges.empty())
        return Outcome::kProbed; // it misses the domain
    choose_axes(outline);
    Slab all{edges_.front().source.z, edges_.front().source.z};
    for (const Segment3& edge : edges_)
        all = {std::min({all.low, edge.source.z, edge.target.z}),
               std::max({all.high, edge.source.z, edge.target.z})};
    return probe_slab(all);
}

// The diameter, nearly: from the point farthest from the origin to the point farthest from that.
void SlabProbing::choose_axes(const ConvexOutline& outline)
{
    const auto farthest_end = [&](const Point3& from)
    {
        Point3 farthest = from;
        double squared = -1.0;
        for (const Segment3& edge : outline.edges)
        {
            for (const Point3& end : {edge.source, edge.target})
            {
                const double other = squared_distance(end, from);
                if (other > squared)
                {
                    squared = other;
                    farthest = end;
                }
            }
        }
        return farthest;
    };
    const Point3 end = farthest_end({});
    const Vec3 diameter = farthest_end(end) - end;
    const Vec3 w = diameter == Vec3{} ? Vec3{0, 0, 1} : normalized(diameter);
    const auto [u, v] = orthonormal_basis(w);
    axis_ = {u, v, w};
    origin_ = outline.origin;
    edges_.clear();
    for (const Segment3& edge : outline.edges)
        edges_.push_back({coordinates_along(axis_, edge.source), coordinates_along(axis_, edge.target)});
}

SlabProbing::Outcome SlabProbing::probe_slab(const Slab& slab)
{
    clip_to(slab);
    if (points_.empty())
        return Outcome::kProbed;
    Vec3 low = points_.front();
    Vec3 high = low;
    for (const Vec3& p : points_)
    {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec3 middle = 0.5 * (low + high);
    const double radius = radius_around(middle);
    if (radius <= reach_)
        return Outcome::kProbed;
    if (probing_.certify(world_box_of_points()))
        return Outcome::kProbed;
    if (radius <= std::numbers::sqrt2 * reach_)
        return probe_axis({low.z, high.z}, middle);
    if (slab.high - slab.low > kShortestSlab * reach_)
    {
        const double at = cut(slab);
        const Outcome outcome = probe_slab({slab.low, at});
        return outcome == Outcome::kProbed ? probe_slab({at, slab.high}) : outcome;
    }
    hub_ = points_.front();
    const Box3 box{low, high};
    set_leaves(box);
    const ProbeRing* ring = ring_for(std::sqrt(radius * radius - reach_ * reach_), reach_);
    if (ring != nullptr && ring->queries < tile_queries())
        return probe_ring({low.z, high.z}, middle, radius, *ring);
    return probe_box(box);
}

// Where to cut a slab in two: beyond the surface at the site if that is in it, in the middle otherwise.
double SlabProbing::cut(const Slab& slab) const
{
    const double margin = 0.25 * kNearSlab * reach_;
    for (const double at : {kNearSlab * reach_, -kNearSlab * reach_})
    {
        if (slab.low + margin < at && at < slab.high - margin)
            return at;
    }
    return 0.5 * (slab.low + slab.high);
}

// The ends of the edges' parts in the slab.
void SlabProbing::clip_to(const Slab& slab)
{
    points_.clear();
    for (const Segment3& edge : edges_)
    {
        const auto [low, high] = std::minmax(edge.source.z, edge.target.z);
        if (high < slab.low || low > slab.high)
            continue;
        const double rise = edge.target.z - edge.source.z;
        for (const Vec3& end : {edge.source, edge.target})
        {
            const double z = std::clamp(end.z, slab.low, slab.high);
            points_.push_back(z == end.z ? end : edge.at((z - edge.source.z) / rise));
        }
    }
}

Box3 SlabProbing::world_box_of_points() const
{
    Box3 box;
    for (const Vec3& p : points_)
        box.include(world(p));
    return box;
}

double SlabProbing::radius_around(const Vec3& middle) const
{
    double squared = 0.0;
    for (const Vec3& p : points_)
        squared =
            std::max(squared, (p.x - middle.x) * (p.x - middle.x) + (p.y - middle.y) * (p.y - middle.y));
    return std::sqrt(squared);
}

// Along the axis, and from it straight to the nearest point of an edge that is known.
SlabProbing::Outcome SlabProbing::probe_axis(const Slab& slab, const Vec3& middle)
{
    const auto on_axis = [&](double z) { return Vec3{middle.x, middle.y, z}; };
    const Outcome outcome = query(on_axis(slab.low), on_axis(slab.high));
    if (outcome != Outcome::kProbed)
        return outcome;
    const Vec3& end =
        *std::min_element(points_.begin(), points_.end(),
                          [&](const Vec3& a, const Vec3& b)
                          { return squared_norm(a - on_axis(a.z)) < squared_norm(b - on_axis(b.z)); });
    return query(on_axis(end.z), end);
}

// The probes of the ring, those that join opposite ones, or neighbours where there are three, and one to an
// edge.
SlabProbing::Outcome SlabProbing::probe_ring(const Slab& slab, const Vec3& middle, double radius,
                                             const ProbeRing& ring)
{
    const double at = ring.ring_radius() * std::sqrt(radius * radius - reach_ * reach_);
    const auto foot = [&](std::size_t k, double z)
    {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(ring.around);
        return Vec3{middle.x + at * std::cos(angle), middle.y + at * std::sin(angle), z};
    };
    for (std::size_t k = 0; k < ring.around; ++k)
    {
        if (query(foot(k, slab.low), foot(k, slab.high)) == Outcome::kNews)
            return Outcome::kNews;
    }
    if (ring.on_axis &&
        query({middle.x, middle.y, slab.low}, {middle.x, middle.y, slab.high}) == Outcome::kNews)
        return Outcome::kNews;
    const double height = 0.5 * (slab.low + slab.high);
    const bool has_opposite = ring.around % 2 == 0;
    const std::size_t joining = has_opposite ? ring.around / 2 : ring.around - 1;
    for (std::size_t k = 0; k < joining; ++k)
    {
        const std::size_t other = has_opposite ? k + ring.around / 2 : k + 1;
        if (query(foot(k, height), foot(other, height)) == Outcome::kNews)
            return Outcome::kNews;
    }
    return query(foot(0, height), hub_);
}

// Cuts a box into leaves not wider than the tiles of Probing.
void SlabProbing::set_leaves(const Box3& box)
{
    const double side = std::numbers::sqrt2 * kTileHalfDiagonal * reach_;
    const Vec3 extent = box.extent();
    leaf_origin_ = box.min;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const double count = std::max(std::ceil(extent[axis] / side), 1.0);
        if (count > kMostLeaves)
            throw UsageError("the reach is " + number_text(reach_) + "; it must be at least " +
                             number_text(extent[axis] / kMostLeaves) + " for a domain of this size");
        leaves_[axis] = static_cast<std::size_t>(count);
        leaf_side_[axis] = extent[axis] / count;
    }
}

std::size_t SlabProbing::tile_queries() const
{
    const auto [columns, rows, layers] = leaves_;
    return columns * rows + (columns > 1 ? rows : 0) + (rows > 1 ? 1 : 0) + 1;
}

SlabProbing::Outcome SlabProbing::probe_box(const Box3& box)
{
    if (leaves_[0] * leaves_[1] <= kFewTiles)
        return probe_tiles(box);
    return effort_ == Effort::kFewProbes ? Outcome::kUnfinished : probe_leaves({{0, 0, 0}, leaves_});
}

// One probe through the middle of each tile from end to end, one across each row of them, and one across the
// rows.
SlabProbing::Outcome SlabProbing::probe_tiles(const Box3& box)
{
    const auto& leaves = leaves_;
    const double height = 0.5 * (box.min.z + box.max.z);
    const auto middle = [&](std::size_t i, std::size_t j, double z)
    {
        return Vec3{box.min.x + (static_cast<double>(i) + 0.5) * leaf_side_.x,
                    box.min.y + (static_cast<double>(j) + 0.5) * leaf_side_.y, z};
    };
    for (std::size_t j = 0; j < leaves[1]; ++j)
    {
        for (std::size_t i = 0; i < leaves[0]; ++i)
        {
            if (query(middle(i, j, box.min.z), middle(i, j, box.max.z)) == Outcome::kNews)
                return Outcome::kNews;
        }
        if (leaves[0] > 1 && query(middle(0, j, height), middle(leaves[0] - 1, j, height)) == Outcome::kNews)
            return Outcome::kNews;
    }
    if (leaves[1] > 1 && query(middle(0, 0, height), middle(0, leaves[1] - 1, height)) == Outcome::kNews)
        return Outcome::kNews;
    return query(middle(0, 0, height), hub_);
}

// Halves what cannot be certified, on a grid of leaves: a leaf and the certified box, or the leaf, beyond one
// of its sides share the whole side.
SlabProbing::Outcome SlabProbing::probe_leaves(const LeafRange& range)
{
    const Box3 box = box_of(range);
    if (is_certified(box))
        return Outcome::kProbed;
    std::size_t axis = 2;
    for (const std::size_t other : {1U, 0U})
    {
        if (range.end[other] - range.begin[other] > range.end[axis] - range.begin[axis])
            axis = other;
    }
    if (range.end[axis] - range.begin[axis] == 1)
        return probe_leaf(box);
    LeafRange lower = range;
    LeafRange upper = range;
    lower.end[axis] = upper.begin[axis] = range.begin[axis] + (range.end[axis] - range.begin[axis]) / 2;
    const Outcome outcome = probe_leaves(lower);
    return outcome == Outcome::kProbed ? probe_leaves(upper) : outcome;
}

Box3 SlabProbing::box_of(const LeafRange& range) const
{
    Box3 box{leaf_origin_, leaf_origin_};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        box.min[axis] += static_cast<double>(range.begin[axis]) * leaf_side_[axis];
        box.max[axis] += static_cast<double>(range.end[axis]) * leaf_side_[axis];
    }
    return box;
}

bool SlabProbing::is_certified(const Box3& box)
{
    const Vec3 half = 0.5 * box.extent();
    Vec3 world_half;
    for (std::size_t a = 0; a < 3; ++a)
        world_half[a] =
            std::abs(axis_[0][a]) * half.x + std::abs(axis_[1][a]) * half.y + std::abs(axis_[2][a]) * half.z;
    const Point3 center = world(box.center());
    return probing_.certify({center - world_half, center + world_half});
}

SlabProbing::Outcome SlabProbing::probe_leaf(const Box3& leaf)
{
    for (const std::size_t axis : {2U, 0U, 1U})
    {
        Vec3 along;
        along[axis] = 0.5 * leaf.extent()[axis];
        if (query(leaf.center() - along, leaf.center() + along) == Outcome::kNews)
            return Outcome::kNews;
    }
    const bool has_hub = leaf.expanded(kRoundingInReaches * reach_).contains(hub_);
    return has_hub ? query(leaf.center(), hub_) : Outcome::kProbed;
}

SlabProbing::Outcome SlabProbing::query(const Vec3& from, const Vec3& to)
{
    news_ = probing_.query({world(from), world(to)}, *is_news_);
    return news_ ? Outcome::kNews : Outcome::kProbed;
}

} // namespace voroprobe
