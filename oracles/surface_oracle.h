#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/box3.h"
#include "geometry/segment3.h"
#include "volume/neck.h"
#include "volume/region.h"
#include "volume/surface_point.h"

namespace voroprobe
{

//! A point where a segment changes side.
struct Crossing
{
    double t;               //!< parameter along the segment, in [0, 1]
    Point3 point;           //!< segment.at(t)
    bool on_border = false; //!< the object leaves the domain here: a cap, not the surface itself
};

//! The only thing the mesher knows of a surface. The surface is closed and bounds an object inside
//! `domain()`.
//!
//! Inside rule: a point is inside where the field is at least the isovalue (at most, for oracles of signed
//! distances); a sample equal to the isovalue is inside. Stated here once; every oracle keeps it.
//!
//! Frame: the oracle's own orthonormal right-handed frame, scan units (for volumes: the grid frame).
//! Stateless: all functions may be called from several threads at once. Source: Feree & Alliez 2009, Sec. 1
//! (oracle).
class SurfaceOracle
{
public:
    virtual ~SurfaceOracle() = default;

    //! A box that holds the object. Beyond it region() answers kOuterRegion and no segment crosses.
    [[nodiscard]] virtual Box3 domain() const = 0;

    //! The region that holds p; kOuterRegion for points beyond the domain and for NaN or infinite
    //! coordinates.
    [[nodiscard]] virtual Region region(const Point3& p) const = 0;

    //! All proper crossings of the segment with the surface, in order from source to target, into `crossings`
    //! (cleared first). Sees even numbers of crossings; touching without changing side is not a crossing.
    //! Consistent with region(): the number is odd exactly where is_inside(region(source)) !=
    //! is_inside(region(target)). The ends may lie far beyond the domain. Cost: proportional to the grid
    //! cells met near the surface for volumes.
    virtual void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const = 0;

    //! False only where it is certain that no point of the surface lies in the box.
    [[nodiscard]] virtual bool may_cross(const Box3& box) const = 0;

    //! The surface that separates two regions; kNoSurface where they are no neighbours. Without an inventory
    //! everything between inside and outside is surface 0.
    [[nodiscard]] virtual SurfaceId surface_between(Region a, Region b) const
    {
        return is_inside(a) != is_inside(b) ? 0 : kNoSurface;
    }

    //! The surface that passes through a crossing found by find_crossings(); kNoSurface where rounding hides
    //! it.
    [[nodiscard]] virtual SurfaceId surface_at(const Point3& /*crossing*/) const { return 0; }

    //! Surfaces that the inventory lists: their ids run below this. 0: there is no inventory, and the
    //! functions below are not to be called.
    [[nodiscard]] virtual std::size_t surface_count() const { return 0; }

    //! The regions that a surface separates.
    [[nodiscard]] virtual SurfaceSides sides(SurfaceId /*surface*/) const { return {1, kOuterRegion}; }

    //! The surface that bounds a region towards the outer region; kNoSurface for the outer region itself.
    [[nodiscard]] virtual SurfaceId surface_around(Region region) const
    {
        return region == kOuterRegion ? kNoSurface : 0;
    }

    //! For each of the surfaces up to `most` of its points, spread over it.
    [[nodiscard]] virtual std::vector<std::vector<Point3>> points_on(std::span<const SurfaceId> surfaces,
                                                                     std::size_t /*most*/) const
    {
        return std::vector<std::vector<Point3>>(surfaces.size());
    }

    //! Points spread over all surfaces: of each one in every cube of this side (scan units) that it passes,
    //! but for cubes that it only just enters. `threads`: 0 for all there are; the answer is the same for
    //! any.
    [[nodiscard]] virtual std::vector<SurfacePoint> points_in_cubes(double /*side*/,
                                                                    std::size_t /*threads*/) const
    {
        return {};
    }

    //! 2 - 2 genus of a surface of the inventory.
    [[nodiscard]] virtual int euler_characteristic(SurfaceId /*surface*/) const { return 2; }

    //! Where the scan joins two parts of a region by a hair.
    [[nodiscard]] virtual std::vector<Neck> necks() const { return {}; }
};

} // namespace voroprobe
