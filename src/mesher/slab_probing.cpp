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
constexpr std::size_t kFewTiles = 40;
// Largest number of leaves along a side: wider boxes than this would take hours.
constexpr double kMostLeaves = 1U << 20U;

} // namespace

//! Probes along a cylinder around its axis, evenly, and one on it perhaps: as disks that cover a disk.
struct ProbeRing
{
    std::size_t around;
    bool on_axis;

    [[nodiscard]] std::size_t count() const { return around + (on_axis ? 1 : 0); }

    //! Radius of the disks that cover a disk of radius 1. Without one in the middle they stand on the sides
    //! of the polygon inscribed into it; with one, neighbours meet on its circle and on the large one.
    [[nodiscard]] double disk_radius() const
    {
        return on_axis ? 1.0 / (1.0 + 2.0 * std::cos(2.0 * angle())) : std::sin(angle());
    }
    [[nodiscard]] double ring_radius() const
    {
        return std::cos(angle()) * (on_axis ? 2.0 * disk_radius() : 1.0);
    }

private:
    //! Half of that between neighbours.
    [[nodiscard]] double angle() const { return std::numbers::pi / static_cast<double>(around); }
};

namespace
{

//! Of the corners of a box above an origin.
std::array<double, 8> heights_of(const Box3& box, const Point3& origin, const Vec3& axis)
{
    std::array<double, 8> heights{};
    for (std::size_t c = 0; c < heights.size(); ++c)
    {
        const Point3 corner{(c & 1U) != 0 ? box.max.x : box.min.x, (c & 2U) != 0 ? box.max.y : box.min.y,
                            (c & 4U) != 0 ? box.max.z : box.min.z};
        heights[c] = dot(axis, corner - origin);
    }
    return heights;
}

template <typename Heights>
Slab slab_around(const Heights& heights)
{
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    return {*low, *high};
}

constexpr std::array<ProbeRing, 6> kProbeRings{
    {{3, false}, {4, false}, {6, true}, {7, true}, {8, true}, {9, true}}};

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

SlabProbing::Outcome SlabProbing::probe(const ConvexOutline& outline, const IsNews& is_news, Effort effort)
{
    outline_ = &outline;
    is_news_ = &is_news;
    effort_ = effort;
    certified_boxes_.clear();
    if (outline.edges.empty())
        return Outcome::kProbed; // it misses the domain
    choose_axes();
    heights_.clear();
    for (const Vec3& corner : outline.corners)
        heights_.push_back(dot(axis_[2], corner));
    const Slab all = slab_around(heights_);
    const Slab domain = slab_around(heights_of(outline.bounds, outline.origin, axis_[2]));
    const Slab slab{std::max(all.low, domain.low), std::min(all.high, domain.high)};
    return slab.low <= slab.high ? probe_slab(slab) : Outcome::kProbed;
}

// The diameter, nearly: from the point farthest from the origin to the point farthest from that.
void SlabProbing::choose_axes()
{
    const Vec3 end = farthest_from(outline_->corners, {});
    const Vec3 diameter = farthest_from(outline_->corners, end) - end;
    const Vec3 w = diameter == Vec3{} ? Vec3{0, 0, 1} : normalized(diameter);
    const auto [u, v] = orthonormal_basis(w);
    axis_ = {u, v, w};
}

SlabProbing::Outcome SlabProbing::probe_slab(const Slab& slab)
{
    collect_points(*outline_, heights_, slab, points_);
    if (points_.empty() || certify_points())
        return Outcome::kProbed;
    const Box3 box = box_of_points();
    const Vec3 middle = box.center();
    const double radius = radius_around(middle);
    if (radius <= reach_)
        return Outcome::kProbed;
    if (radius <= std::numbers::sqrt2 * reach_)
        return probe_axis(slab, middle);
    if (slab.high - slab.low > kShortestSlab * reach_)
        return probe_halves(slab);
    hub_ = local_points_.front();
    set_leaves(box);
    const ProbeRing* ring = ring_for(std::sqrt(radius * radius - reach_ * reach_), reach_);
    if (ring != nullptr && ring->count() < leaves_[0] * leaves_[1])
        return probe_ring(slab, middle, radius, *ring);
    return probe_box(slab, box);
}

// The half away from the site first: where that is certified it joins the probes of the other.
SlabProbing::Outcome SlabProbing::probe_halves(const Slab& slab)
{
    const double at = cut(slab);
    Slab first{slab.low, at};
    Slab second{at, slab.high};
    if (at > 0.0)
        std::swap(first, second);
    const Outcome outcome = probe_slab(first);
    return outcome == Outcome::kProbed ? probe_slab(second) : outcome;
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

bool SlabProbing::certify_points()
{
    Box3 box;
    for (const Vec3& p : points_)
        box.include(p);
    certified_boxes_.push_back(box);
    const Box3 in_world{outline_->origin + box.min, outline_->origin + box.max};
    const Box3 in_domain = intersection(in_world, outline_->bounds);
    if (in_domain.empty() || probing_.certify(in_domain))
        return true;
    certified_boxes_.pop_back();
    return false;
}

// In coordinates along the axes.
Box3 SlabProbing::box_of_points()
{
    Box3 box;
    local_points_.clear();
    for (const Vec3& p : points_)
    {
        local_points_.push_back({dot(axis_[0], p), dot(axis_[1], p), dot(axis_[2], p)});
        box.include(local_points_.back());
    }
    return box;
}

double SlabProbing::radius_around(const Vec3& middle) const
{
    double squared = 0.0;
    for (const Vec3& p : local_points_)
        squared =
            std::max(squared, (p.x - middle.x) * (p.x - middle.x) + (p.y - middle.y) * (p.y - middle.y));
    return std::sqrt(squared);
}

bool SlabProbing::is_in_certified_box(const Vec3& c) const
{
    const Vec3 p = relative(c);
    return std::any_of(certified_boxes_.begin(), certified_boxes_.end(),
                       [&](const Box3& box) { return box.contains(p); });
}

// A probe across the slab, and another one straight to the joint unless it is joined at its ends.
SlabProbing::Outcome SlabProbing::probe_along(const Slab& slab, const Vec3& foot, const Vec3& joint)
{
    const auto at_height = [&](double z) { return Vec3{foot.x, foot.y, z}; };
    const Outcome outcome = query(at_height(slab.low), at_height(slab.high));
    if (outcome != Outcome::kProbed || is_in_certified_box(at_height(slab.low)) ||
        is_in_certified_box(at_height(slab.high)))
        return outcome;
    return query(at_height(joint.z), joint);
}

// Along the axis, joined to the nearest point of an edge that is known.
SlabProbing::Outcome SlabProbing::probe_axis(const Slab& slab, const Vec3& middle)
{
    const auto squared_distance_to_axis = [&](const Vec3& p)
    { return (p.x - middle.x) * (p.x - middle.x) + (p.y - middle.y) * (p.y - middle.y); };
    const Vec3& nearest =
        *std::min_element(local_points_.begin(), local_points_.end(),
                          [&](const Vec3& a, const Vec3& b)
                          { return squared_distance_to_axis(a) < squared_distance_to_axis(b); });
    return probe_along(slab, middle, nearest);
}

// The probes of the ring, each joined to the one before.
SlabProbing::Outcome SlabProbing::probe_ring(const Slab& slab, const Vec3& middle, double radius,
                                             const ProbeRing& ring)
{
    const double at = ring.ring_radius() * std::sqrt(radius * radius - reach_ * reach_);
    const double height = 0.5 * (slab.low + slab.high);
    Vec3 joint = hub_;
    for (std::size_t k = 0; k < ring.count(); ++k)
    {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(ring.around);
        const double out = k < ring.around ? at : 0.0; // the last one may be on the axis
        const Vec3 foot{middle.x + out * std::cos(angle), middle.y + out * std::sin(angle), height};
        const Outcome outcome = probe_along(slab, foot, joint);
        if (outcome != Outcome::kProbed)
            return outcome;
        joint = foot;
    }
    return Outcome::kProbed;
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

SlabProbing::Outcome SlabProbing::probe_box(const Slab& slab, const Box3& box)
{
    if (leaves_[0] * leaves_[1] <= kFewTiles)
        return probe_tiles(slab, box);
    return effort_ == Effort::kFewProbes ? Outcome::kUnfinished : probe_leaves({{0, 0, 0}, leaves_});
}

// One probe through the middle of each tile from end to end, each joined to the one before.
SlabProbing::Outcome SlabProbing::probe_tiles(const Slab& slab, const Box3& box)
{
    Vec3 joint = hub_;
    for (std::size_t j = 0; j < leaves_[1]; ++j)
    {
        for (std::size_t i = 0; i < leaves_[0]; ++i)
        {
            // Row by row, there and back.
            const std::size_t column = j % 2 == 0 ? i : leaves_[0] - 1 - i;
            const Vec3 middle{box.min.x + (static_cast<double>(column) + 0.5) * leaf_side_.x,
                              box.min.y + (static_cast<double>(j) + 0.5) * leaf_side_.y,
                              0.5 * (slab.low + slab.high)};
            const Outcome outcome = probe_along(slab, middle, joint);
            if (outcome != Outcome::kProbed)
                return outcome;
            joint = middle;
        }
    }
    return Outcome::kProbed;
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
