#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/segment3.h"

namespace voroprobe
{

//! A grid cell by its lowest corner, index coordinates: it spans [i, i + 1] along each axis.
using GridCell = std::array<int, 3>;

//! Grid cells from `min` to `max`, both included.
struct GridCellBox
{
    GridCell min;
    GridCell max;
};

//! The part of a segment in one grid cell. The points are counted from the grid cell's lowest corner and lie
//! in [0, 1]^3, on the very plane of the face the segment passes.
struct GridCellSpan
{
    double first; //!< parameters along the segment
    double last;
    Vec3 entry;
    Vec3 exit;
};

//! Walks the grid cells along a segment, all of index coordinates. From the first grid cell to the last it
//! goes through faces only, never away from the last, so that it ends after a known number of steps whatever
//! is rounded, and the exit point of a grid cell is the entry point of the next to the last bit. Jumps over
//! boxes of grid cells keep this as if they had been walked. Source: Amanatides & Woo 1987, with parameters
//! computed anew at each plane.
class GridWalk
{
public:
    //! \pre `first` and `last` hold the ends of the segment.
    GridWalk(const Segment3& segment, const GridCell& first, const GridCell& last)
        : source_{segment.source.x, segment.source.y, segment.source.z}, target_{segment.target.x,
                                                                                 segment.target.y,
                                                                                 segment.target.z},
          cell_(first), last_(last)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            along_[axis] = target_[axis] - source_[axis];
            inverse_[axis] = 1.0 / along_[axis];
            ahead_[axis] = last[axis] >= first[axis] ? 1 : 0;
            update_exit(axis);
        }
        choose_exit();
    }

    [[nodiscard]] const GridCell& cell() const { return cell_; }

    //! True when the walk has left the last grid cell.
    [[nodiscard]] bool done() const { return done_; }

    [[nodiscard]] GridCellSpan span() const
    {
        GridCellSpan span{};
        span.first = first_;
        span.last = exit_parameter();
        span.entry = entry_axis_ == kNoAxis ? local(source_)
                                            : face_point(span.first, entry_axis_, 1 - ahead_[entry_axis_]);
        span.exit =
            exit_axis_ == kNoAxis ? local(target_) : face_point(span.last, exit_axis_, ahead_[exit_axis_]);
        return span;
    }

    //! To the next grid cell, through the face where the segment leaves this one.
    void step()
    {
        if (exit_axis_ == kNoAxis)
        {
            done_ = true;
            return;
        }
        first_ = exit_parameter();
        entry_axis_ = exit_axis_;
        cell_[entry_axis_] += 2 * ahead_[entry_axis_] - 1;
        update_exit(entry_axis_);
        choose_exit();
    }

    //! To the first grid cell beyond `box`, which holds this one.
    void leave(const GridCellBox& box)
    {
        std::size_t axis = kNoAxis;
        double nearest = 1.0;
        for (std::size_t a = 0; a < 3; ++a)
        {
            if (ahead_[a] ? last_[a] <= box.max[a] : last_[a] >= box.min[a])
                continue;
            const double plane = ahead_[a] ? box.max[a] + 1 : box.min[a];
            const double parameter = (plane - source_[a]) * inverse_[a];
            if (axis == kNoAxis || parameter < nearest)
            {
                axis = a;
                nearest = parameter;
            }
        }
        if (axis == kNoAxis)
        {
            done_ = true;
            return;
        }
        first_ = std::max(first_, nearest);
        entry_axis_ = axis;
        for (std::size_t a = 0; a < 3; ++a)
        {
            cell_[a] = a == axis ? (ahead_[a] ? box.max[a] + 1 : box.min[a] - 1) : cell_within(a, box);
            update_exit(a);
        }
        choose_exit();
    }

private:
    using Coordinates = std::array<double, 3>; //!< index coordinates, where the axis is a variable

    static constexpr std::size_t kNoAxis = 3;
    static constexpr double kNever = std::numeric_limits<double>::infinity();

    [[nodiscard]] double exit_parameter() const
    {
        return exit_axis_ == kNoAxis ? 1.0 : std::max(first_, exits_[exit_axis_]);
    }

    //! A point of this grid cell, but for rounding, from its lowest corner.
    [[nodiscard]] Vec3 local(const Coordinates& p) const
    {
        const auto within = [](double x) { return std::min(std::max(x, 0.0), 1.0); };
        return {within(p[0] - cell_[0]), within(p[1] - cell_[1]), within(p[2] - cell_[2])};
    }

    //! Where the segment passes the upper (1) or lower (0) face of this grid cell across `axis`.
    [[nodiscard]] Vec3 face_point(double parameter, std::size_t axis, int upper) const
    {
        Vec3 p = local({source_[0] + parameter * along_[0], source_[1] + parameter * along_[1],
                        source_[2] + parameter * along_[2]});
        p[axis] = upper;
        return p;
    }

    //! The grid cell along axis `a` at first_, no farther than `box` and the last, and not back behind this
    //! one.
    [[nodiscard]] int cell_within(std::size_t a, const GridCellBox& box) const
    {
        const int here = static_cast<int>(source_[a] + first_ * along_[a]);
        return ahead_[a] ? std::clamp(here, cell_[a], std::min(last_[a], box.max[a]))
                         : std::clamp(here, std::max(last_[a], box.min[a]), cell_[a]);
    }

    void update_exit(std::size_t axis)
    {
        const double plane = cell_[axis] + ahead_[axis];
        exits_[axis] = cell_[axis] == last_[axis] ? kNever : (plane - source_[axis]) * inverse_[axis];
    }

    void choose_exit()
    {
        const std::size_t xy = exits_[1] < exits_[0] ? 1 : 0;
        const std::size_t nearest = exits_[2] < exits_[xy] ? 2 : xy;
        exit_axis_ = exits_[nearest] == kNever ? kNoAxis : nearest;
    }

    Coordinates source_;
    Coordinates target_;
    Coordinates along_{};
    Coordinates inverse_{};
    Coordinates
        exits_{}; //!< parameter of the next plane along each axis; kNever where the last grid cell lies level
    GridCell cell_;
    GridCell last_;
    std::array<int, 3> ahead_{}; //!< 1 where the segment goes up along the axis, 0 where down
    double first_ = 0.0;
    std::size_t entry_axis_ = kNoAxis;
    std::size_t exit_axis_ = kNoAxis;
    bool done_ = false;
};

} // namespace voroprobe
