#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mesher/convex_outline.h"
#include "mesher/probing.h"

namespace voroprobe
{

struct ProbeRing;

//! probe(C) at a cost that follows the surface and not the region's volume, with the promises of Probing.
//!
//! The region is cut into slabs across its longest extent, at some distance from the site first: near the
//! site there is surface, farther away there seldom is. A slab is done with, in this order,
//!
//! - where the oracle certifies its box to hold no surface: such a slab is a probe as thick as itself;
//! - where it fits into a cylinder as wide as the reach: a section across is a polygon with its corners on
//!   edges, and a point of a convex polygon is no farther from the nearest corner than the radius of a disk
//!   around all of them;
//! - where it fits into a cylinder sqrt(2) times as wide, by a probe along the cylinder's axis: a point x at
//!   least the reach e from the axis has a corner v with (v - x) . (x - axis) >= 0, so |v - x|^2 <= 2 e^2 -
//!   |x - axis|^2 <= e^2;
//! - where it fits into one sqrt(7 / 3), sqrt(3), sqrt(5), ... times as wide, by 3, 4, 7 to 10 probes along
//!   it: the same corner v is near to x beyond sqrt(radius^2 - e^2) from the axis, and disks around the
//!   probes cover what is nearer (see ProbeRing).
//!
//! A probe that ends in a box certified before is joined to an edge by that box. Others get a second probe
//! across, to the one before or to an edge.
//!
//! Otherwise it is cut in two. When it is short its box gets the paper's probes, or where that would take
//! many the box is halved again and again: what cannot be certified, boxes of about the reach, gets three
//! probes between the middles of opposite sides. They meet each other, and the probes or the certified box
//! beyond each side. A last probe joins each slab's to an edge.
class SlabProbing
{
public:
    enum class Outcome
    {
        kProbed,    //!< the region is probed, without news
        kNews,      //!< a crossing is news: news()
        kUnfinished //!< a slab is too wide for the effort allowed
    };
    enum class Effort
    {
        kFewProbes, //!< leave wide slabs
        kAllProbes
    };

    //! The probing must outlive the object.
    explicit SlabProbing(Probing& probing) : probing_(probing), reach_(probing.reach()) {}

    Outcome probe(const ConvexOutline& outline, const IsNews& is_news, Effort effort);

    //! The crossing, after Outcome::kNews.
    [[nodiscard]] const Point3& news() const { return *news_; }

private:
    //! Leaves of a box's grid.
    struct LeafRange
    {
        std::array<std::size_t, 3> begin;
        std::array<std::size_t, 3> end;
    };

    void choose_axes();
    Outcome probe_slab(const Slab& slab);
    Outcome probe_halves(const Slab& slab);
    [[nodiscard]] bool certify_points();
    [[nodiscard]] Box3 box_of_points();
    [[nodiscard]] double radius_around(const Vec3& middle) const;
    [[nodiscard]] double cut(const Slab& slab) const;
    Outcome probe_axis(const Slab& slab, const Vec3& middle);
    Outcome probe_ring(const Slab& slab, const Vec3& middle, double radius, const ProbeRing& ring);
    Outcome probe_along(const Slab& slab, const Vec3& foot, const Vec3& joint);
    [[nodiscard]] bool is_in_certified_box(const Vec3& c) const;
    Outcome probe_box(const Slab& slab, const Box3& box);
    void set_leaves(const Box3& box);
    Outcome probe_tiles(const Slab& slab, const Box3& box);
    Outcome probe_leaves(const LeafRange& range);
    Outcome probe_leaf(const Box3& leaf);
    [[nodiscard]] Box3 box_of(const LeafRange& range) const;
    [[nodiscard]] bool is_certified(const Box3& box);
    Outcome query(const Vec3& from, const Vec3& to);
    //! From coordinates along the axes to those relative to the origin.
    [[nodiscard]] Vec3 relative(const Vec3& c) const
    {
        return c.x * axis_[0] + c.y * axis_[1] + c.z * axis_[2];
    }
    [[nodiscard]] Point3 world(const Vec3& c) const { return outline_->origin + relative(c); }

    Probing& probing_;
    double reach_;

    // Of the region at hand.
    const ConvexOutline* outline_ = nullptr;
    const IsNews* is_news_ = nullptr;
    Effort effort_ = Effort::kAllProbes;
    std::optional<Point3> news_;
    std::array<Vec3, 3> axis_;          //!< the last along the longest extent
    std::vector<double> heights_;       //!< of the outline's corners, along that
    std::vector<Box3> certified_boxes_; //!< of whole slabs, relative to the origin
    std::vector<Vec3> points_;          //!< of the slab at hand, relative to the origin
    std::vector<Vec3> local_points_;    //!< the same, in coordinates along the axes
    Point3 leaf_origin_;                //!< of the box at hand
    Vec3 leaf_side_;
    std::array<std::size_t, 3> leaves_{};
    Vec3 hub_; //!< a point of an edge in the slab at hand
};

} // namespace voroprobe
