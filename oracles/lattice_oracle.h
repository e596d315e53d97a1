#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "oracles/grid_walk.h"
#include "oracles/region_bricks.h"
#include "oracles/surface_oracle.h"
#include "volume/cell_topology.h"
#include "volume/inventory.h"
#include "volume/lattice_frame.h"
#include "volume/necks.h"
#include "volume/spread_crossings.h"
#include "volume/trilinear_cell.h"

namespace voroprobe
{

//! How a LatticeOracle reads samples. Made anew for each call, so that it may hold a cache.
template <class R>
concept LatticeReader = requires(R reader, const GridCell& cell, const GridCellBox& box)
{
    //! The field at the corners of a grid cell: inside where at least 0, of one sign in the outer region.
    {
        reader.corners(cell)
        } -> std::same_as<CellCorners>;
    //! The side of its lowest corner. Asked only of grid cells that are not mixed.
    {
        reader.is_first_corner_inside(cell)
        } -> std::same_as<bool>;
    //! False only where all corners lie on one side.
    {
        reader.is_mixed(cell)
        } -> std::same_as<bool>;
    //! A box around the grid cell, which may reach beyond the lattice, without a mixed grid cell; empty where
    //! it is not worth the look.
    {
        reader.clear_box(cell)
        } -> std::same_as<std::optional<GridCellBox>>;
    //! Is there a mixed grid cell in the box?
    {
        reader.any_mixed(box)
        } -> std::same_as<bool>;
};

//! What a LatticeOracle knows of the regions of its samples; the inventory is that of the heights.
struct LatticeRegions
{
    std::shared_ptr<const Inventory> inventory; //!< may be null: then regions are +1 and -1
    std::shared_ptr<const HeightField> heights; //!< asked for points on surfaces alone
};

//! The zero set of the trilinear interpolant over a lattice, closed by the faces of the lattice's box.
//! `Lattice` knows the samples: `frame()` says where they lie, `reader()` makes a LatticeReader.
template <class Lattice>
class LatticeOracle final : public SurfaceOracle
{
public:
    explicit LatticeOracle(Lattice lattice, LatticeRegions regions = {})
        : lattice_(std::move(lattice)), frame_(lattice_.frame()), regions_(std::move(regions))
    {
        if (regions_.inventory)
            bricks_.emplace(regions_.inventory->runs());
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            last_sample_[axis] = frame_.sample_count[axis] - 1;
            inverse_step_[axis] = 1.0 / frame_.step[axis];
        }
        domain_.include(frame_.first);
        domain_.include(frame_.first + Vec3{frame_.step.x * last_sample_.x, frame_.step.y * last_sample_.y,
                                            frame_.step.z * last_sample_.z});
    }

    [[nodiscard]] Box3 domain() const override { return domain_; }

    [[nodiscard]] Region region(const Point3& p) const override
    {
        if (!domain_.contains(p))
            return kOuterRegion;
        auto&& reader = lattice_.reader();
        const Point3 p_index = index_of(p);
        if (bricks_)
            return listed_region(reader, cell_at(p_index), p_index);
        return is_inside_at(reader, p_index) ? Region{1} : kOuterRegion;
    }

    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override;
    [[nodiscard]] bool may_cross(const Box3& box) const override;

    [[nodiscard]] SurfaceId surface_between(Region a, Region b) const override
    {
        return bricks_ ? regions_.inventory->surface_between(a, b) : SurfaceOracle::surface_between(a, b);
    }
    [[nodiscard]] SurfaceId surface_at(const Point3& crossing) const override;
    [[nodiscard]] std::size_t surface_count() const override
    {
        return bricks_ ? regions_.inventory->surfaces().size() : 0;
    }
    [[nodiscard]] SurfaceSides sides(SurfaceId surface) const override
    {
        if (!bricks_)
            return SurfaceOracle::sides(surface);
        const ScanSurface& listed = regions_.inventory->surfaces()[static_cast<std::size_t>(surface)];
        return {listed.inside, listed.outside};
    }
    [[nodiscard]] SurfaceId surface_around(Region region) const override
    {
        return bricks_ ? regions_.inventory->surface_around(region) : SurfaceOracle::surface_around(region);
    }
    [[nodiscard]] std::vector<std::vector<Point3>> points_on(std::span<const SurfaceId> surfaces,
                                                             std::size_t most) const override
    {
        return bricks_ ? grid_crossings(*regions_.heights, *regions_.inventory, surfaces, most)
                       : SurfaceOracle::points_on(surfaces, most);
    }
    [[nodiscard]] std::vector<SurfacePoint> points_in_cubes(double side, std::size_t threads) const override
    {
        return bricks_ ? spread_crossings(*regions_.heights, *regions_.inventory, side, threads)
                       : SurfaceOracle::points_in_cubes(side, threads);
    }
    [[nodiscard]] int euler_characteristic(SurfaceId surface) const override
    {
        return bricks_
                   ? regions_.inventory->surfaces()[static_cast<std::size_t>(surface)].euler_characteristic
                   : SurfaceOracle::euler_characteristic(surface);
    }
    [[nodiscard]] std::vector<Neck> necks() const override
    {
        return bricks_ ? find_necks(*regions_.heights, *regions_.inventory) : SurfaceOracle::necks();
    }

private:
    //! A segment of index coordinates clipped to the domain.
    struct ClippedSegment
    {
        Segment3 part;
        ParameterRange range{0.0, 1.0}; //!< parameters of the part's ends along the whole segment
        bool enters = false;            //!< the whole segment begins beyond the domain
        bool leaves = false;
    };

    //! By how much may_cross() grows its box, grid edges: covers the rounding of the box's and the surface's
    //! coordinates.
    static constexpr double kBoxRounding = 1e-9;

    //! How far from the surface or the border the rounding of its coordinates may put a crossing, grid edges.
    static constexpr double kCrossingRounding = 1e-9;

    //! The region by the inventory: that of a corner reached from the point without a change of side.
    [[nodiscard]] Region listed_region(LatticeReader auto& reader, const GridCell& cell,
                                       const Point3& p_index) const
    {
        if (!reader.is_mixed(cell))
        {
            const Region only = bricks_->only_region(cell, reader.is_first_corner_inside(cell));
            return only != RegionBricks::kSeveral ? only : corner_region(cell, 0);
        }
        const CellCorners corners = reader.corners(cell);
        const Vec3 p_local = local(p_index, cell);
        const bool inside = trilinear_value(corners, p_local) >= 0.0;
        if (const Region only = bricks_->only_region(cell, inside); only != RegionBricks::kSeveral)
            return only;
        return corner_region(cell,
                             inside ? corner_uphill(corners, p_local) : corner_downhill(corners, p_local));
    }

    [[nodiscard]] Region corner_region(const GridCell& cell, std::size_t corner) const
    {
        return regions_.inventory->region(cell[0] + static_cast<int>(corner & 1U),
                                          cell[1] + static_cast<int>(corner >> 1U & 1U),
                                          cell[2] + static_cast<int>(corner >> 2U));
    }

    [[nodiscard]] bool is_on_border(const Point3& p_index) const
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (p_index[axis] <= kCrossingRounding || p_index[axis] >= last_sample_[axis] - kCrossingRounding)
                return true;
        return false;
    }

    //! The surface between the regions uphill and downhill of a crossing in a grid cell. Beyond the border is
    //! the outer region.
    [[nodiscard]] SurfaceId surface_in_cell(LatticeReader auto& reader, const GridCell& cell,
                                            const Point3& crossing_index) const
    {
        const CornersBeside beside = corners_beside(reader.corners(cell), local(crossing_index, cell));
        const Region inside = corner_region(cell, beside.uphill);
        const Region outside =
            is_on_border(crossing_index) ? kOuterRegion : corner_region(cell, beside.downhill);
        return regions_.inventory->surface_between(inside, outside);
    }

    //! Index coordinates of a point of the domain, counted from the first sample.
    [[nodiscard]] Point3 index_of(const Point3& p) const
    {
        return {std::clamp((p.x - frame_.first.x) * inverse_step_.x, 0.0, last_sample_.x),
                std::clamp((p.y - frame_.first.y) * inverse_step_.y, 0.0, last_sample_.y),
                std::clamp((p.z - frame_.first.z) * inverse_step_.z, 0.0, last_sample_.z)};
    }

    [[nodiscard]] GridCell cell_at(const Point3& p_index) const
    {
        return {std::min(static_cast<int>(p_index.x), frame_.sample_count[0] - 2),
                std::min(static_cast<int>(p_index.y), frame_.sample_count[1] - 2),
                std::min(static_cast<int>(p_index.z), frame_.sample_count[2] - 2)};
    }

    [[nodiscard]] static Vec3 local(const Point3& p_index, const GridCell& cell)
    {
        return {p_index.x - cell[0], p_index.y - cell[1], p_index.z - cell[2]};
    }

    [[nodiscard]] static bool is_inside_at(LatticeReader auto& reader, const GridCell& cell,
                                           const Point3& p_index)
    {
        if (!reader.is_mixed(cell))
            return reader.is_first_corner_inside(cell);
        return trilinear_value(reader.corners(cell), local(p_index, cell)) >= 0.0;
    }
    [[nodiscard]] bool is_inside_at(LatticeReader auto& reader, const Point3& p_index) const
    {
        return is_inside_at(reader, cell_at(p_index), p_index);
    }

    [[nodiscard]] std::optional<ClippedSegment> clip(const Segment3& segment) const;

    Lattice lattice_;
    LatticeFrame frame_;
    LatticeRegions regions_;
    std::optional<RegionBricks> bricks_; //!< where there is an inventory
    Vec3 inverse_step_;
    Vec3 last_sample_;
    Box3 domain_;
};

template <class Lattice>
auto LatticeOracle<Lattice>::clip(const Segment3& segment) const -> std::optional<ClippedSegment>
{
    ClippedSegment clipped;
    clipped.enters = !domain_.contains(segment.source);
    clipped.leaves = !domain_.contains(segment.target);
    if (clipped.enters || clipped.leaves)
    {
        if (!is_finite(segment.source) || !is_finite(segment.target))
            return std::nullopt;
        const auto range = clip_to_box(segment, domain_);
        if (!range)
            return std::nullopt;
        clipped.range = *range;
    }
    clipped.part = {index_of(clipped.enters ? segment.at(clipped.range.first) : segment.source),
                    index_of(clipped.leaves ? segment.at(clipped.range.second) : segment.target)};
    return clipped;
}

template <class Lattice>
void LatticeOracle<Lattice>::find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const
{
    crossings.clear();
    const auto clipped = clip(segment);
    if (!clipped)
        return;
    const auto [first, last] = clipped->range;
    const auto append = [&](double t, bool on_border) { crossings.push_back({t, segment.at(t), on_border}); };
    auto&& reader = lattice_.reader();

    if (clipped->enters && is_inside_at(reader, clipped->part.source))
        append(first, true);
    GridWalk walk(clipped->part, cell_at(clipped->part.source), cell_at(clipped->part.target));
    while (!walk.done())
    {
        if (const auto clear = reader.clear_box(walk.cell()))
        {
            walk.leave(*clear);
            continue;
        }
        if (reader.is_mixed(walk.cell()))
        {
            const GridCellSpan span = walk.span();
            const BernsteinCubic cubic =
                restrict_to_segment(reader.corners(walk.cell()), span.entry, span.exit);
            if (!stays_on_one_side(cubic))
            {
                const CubicRoots roots = find_sign_changes(cubic);
                for (std::size_t i = 0; i < roots.count; ++i)
                {
                    const double along = span.first + roots.parameter[i] * (span.last - span.first);
                    append(std::min(first + std::min(along, span.last) * (last - first), last), false);
                }
            }
        }
        walk.step();
    }
    if (clipped->leaves && is_inside_at(reader, clipped->part.target))
        append(last, true);
}

template <class Lattice>
SurfaceId LatticeOracle<Lattice>::surface_at(const Point3& crossing) const
{
    if (!bricks_)
        return SurfaceOracle::surface_at(crossing);
    auto&& reader = lattice_.reader();
    const Point3 p_index = index_of(crossing);
    const SurfaceId found = surface_in_cell(reader, cell_at(p_index), p_index);
    if (found != kNoSurface)
        return found;

    // Rounding may have put it into the next grid cell, which the surface only touches.
    for (int i = 0; i < 8; ++i)
    {
        const Point3 nearby{
            std::clamp(p_index.x + (i & 1 ? 1 : -1) * kCrossingRounding, 0.0, last_sample_.x),
            std::clamp(p_index.y + (i & 2 ? 1 : -1) * kCrossingRounding, 0.0, last_sample_.y),
            std::clamp(p_index.z + (i & 4 ? 1 : -1) * kCrossingRounding, 0.0, last_sample_.z)};
        const SurfaceId next = surface_in_cell(reader, cell_at(nearby), nearby);
        if (next != kNoSurface)
            return next;
    }
    return kNoSurface;
}

template <class Lattice>
bool LatticeOracle<Lattice>::may_cross(const Box3& box) const
{
    const Box3 grown = box.expanded(kBoxRounding * norm(frame_.step));
    Box3 part;
    bool at_border = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        part.min[axis] = std::max(domain_.min[axis], grown.min[axis]);
        part.max[axis] = std::min(domain_.max[axis], grown.max[axis]);
        at_border = at_border || part.min[axis] == domain_.min[axis] || part.max[axis] == domain_.max[axis];
    }
    if (part.empty())
        return false;

    auto&& reader = lattice_.reader();
    const GridCell a = cell_at(index_of(part.min));
    const GridCell b = cell_at(index_of(part.max));
    const GridCellBox cells{{std::min(a[0], b[0]), std::min(a[1], b[1]), std::min(a[2], b[2])},
                            {std::max(a[0], b[0]), std::max(a[1], b[1]), std::max(a[2], b[2])}};
    if (reader.any_mixed(cells))
        return true;
    return at_border &&
           is_inside_at(reader, index_of(part.min)); // one side throughout: its cap, if it is the inside
}

} // namespace voroprobe
