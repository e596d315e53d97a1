#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "oracles/surface_oracle.h"
#include "oracles/trilinear_oracle.h"

namespace voroprobe
{

//! Slow and obvious: the crossings of a segment with the trilinear isosurface of a volume, by sampling each
//! grid cell's stretch of the segment as finely as bounds on the interpolant's slope and curvature ask for.
class TrilinearReference
{
public:
    //! Crossings nearer to each other than this, in grid edges, may be passed over in pairs.
    static constexpr double kFinest = 1e-9;

    TrilinearReference(const Volume& volume, double isovalue, InsideIs inside)
        : size_(volume.geometry.size), spacing_(volume.geometry.spacing),
          sign_(inside == InsideIs::kAbove ? 1.0 : -1.0)
    {
        double smallest = std::numeric_limits<double>::infinity();
        bool tie = false;
        std::visit(
            [&](const auto& samples)
            {
                for (const auto sample : samples)
                {
                    field_.push_back(sign_ * (static_cast<double>(sample) - isovalue));
                    tie = tie || field_.back() == 0.0;
                    if (field_.back() != 0.0)
                        smallest = std::min(smallest, std::abs(field_.back()));
                }
            },
            volume.samples);
        for (double& value : field_)
            value += tie ? smallest * 0.0037 : 0.0;
    }

    //! Parameters of the crossings, ascending; those on the border of the samples' box included.
    std::vector<double> crossings(const Segment3& segment)
    {
        found_.clear();
        source_ = index_of(segment.source);
        along_ = index_of(segment.target) - source_;
        length_ = norm(along_);
        std::vector<double> stops = planes_passed();
        if (stops.empty())
            return {};
        const auto inside_at = [&](double first, double t)
        { return value(cell_between(first, t), t) >= 0.0; };
        if (stops.front() > 0.0 && inside_at(stops.front(), stops.front()))
            found_.push_back(stops.front());
        for (std::size_t i = 0; i + 1 < stops.size(); ++i)
            if (stops[i] < stops[i + 1])
                search(Stretch(*this, cell_between(stops[i], stops[i + 1])), stops[i], stops[i + 1]);
        if (stops.back() < 1.0 && inside_at(stops.back(), stops.back()))
            found_.push_back(stops.back());
        return found_;
    }

private:
    using Cell = std::array<std::size_t, 3>;

    Point3 index_of(const Point3& p) const { return {p.x / spacing_.x, p.y / spacing_.y, p.z / spacing_.z}; }

    double sample(std::size_t i, std::size_t j, std::size_t k) const
    {
        return field_[i + size_[0] * (j + size_[1] * k)];
    }

    //! Where the segment enters the box, passes a grid plane, leaves the box.
    std::vector<double> planes_passed() const
    {
        double first = 0.0;
        double last = 1.0;
        std::vector<double> stops;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const double end = static_cast<double>(size_[axis] - 1);
            if (along_[axis] == 0.0)
            {
                if (source_[axis] < 0.0 || source_[axis] > end)
                    return {};
                continue;
            }
            const double t0 = -source_[axis] / along_[axis];
            const double t1 = (end - source_[axis]) / along_[axis];
            first = std::max(first, std::min(t0, t1));
            last = std::min(last, std::max(t0, t1));
            for (std::size_t plane = 0; plane < size_[axis]; ++plane)
                stops.push_back((static_cast<double>(plane) - source_[axis]) / along_[axis]);
        }
        if (first > last)
            return {};
        std::erase_if(stops, [&](double t) { return t <= first || t >= last; });
        stops.push_back(first);
        stops.push_back(last);
        std::sort(stops.begin(), stops.end());
        return stops;
    }

    Cell cell_between(double first, double last) const
    {
        const Point3 middle = source_ + 0.5 * (first + last) * along_;
        Cell cell;
        for (std::size_t axis = 0; axis < 3; ++axis)
            cell[axis] = static_cast<std::size_t>(
                std::clamp(std::floor(middle[axis]), 0.0, static_cast<double>(size_[axis] - 2)));
        return cell;
    }

    //! Sum of the corners with their weights; or, for `derived_axis` < 3, of the weights' derivatives along
    //! the axis.
    double weighted_corners(const Cell& cell, const Point3& p, std::size_t derived_axis) const
    {
        double sum = 0.0;
        for (std::size_t corner = 0; corner < 8; ++corner)
        {
            double weight = 1.0;
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                const double f = p[axis] - static_cast<double>(cell[axis]);
                const bool upper = (corner >> axis & 1U) != 0;
                if (axis == derived_axis)
                    weight *= upper ? 1.0 : -1.0;
                else
                    weight *= upper ? f : 1.0 - f;
            }
            sum += weight *
                   sample(cell[0] + (corner & 1U), cell[1] + (corner >> 1U & 1U), cell[2] + (corner >> 2U));
        }
        return sum;
    }

    double value(const Cell& cell, double t) const { return weighted_corners(cell, source_ + t * along_, 3); }
    double slope(const Cell& cell, double t) const
    {
        const Point3 p = source_ + t * along_;
        return along_.x * weighted_corners(cell, p, 0) + along_.y * weighted_corners(cell, p, 1) +
               along_.z * weighted_corners(cell, p, 2);
    }

    //! A trilinear function takes its extremes over a box at the box's corners; here the box around a piece
    //! of the segment.
    bool box_on_one_side(const Cell& cell, double low, double high) const
    {
        const Point3 a = source_ + low * along_;
        const Point3 b = source_ + high * along_;
        std::size_t inside = 0;
        for (std::size_t i = 0; i < 8; ++i)
        {
            const Point3 corner{i & 1U ? b.x : a.x, i & 2U ? b.y : a.y, i & 4U ? b.z : a.z};
            inside += weighted_corners(cell, corner, 3) >= 0.0;
        }
        return inside == 0 || inside == 8;
    }

    //! A grid cell with bounds on the first and second derivative along the segment.
    struct Stretch
    {
        Stretch(const TrilinearReference& r, const Cell& at) : cell(at)
        {
            const auto corner = [&](std::size_t i)
            { return r.sample(at[0] + (i & 1U), at[1] + (i >> 1U & 1U), at[2] + (i >> 2U)); };
            const std::array<std::size_t, 3> bit{1, 2, 4};
            for (std::size_t a = 0; a < 3; ++a)
            {
                double steepest = 0.0;
                for (std::size_t i = 0; i < 8; ++i)
                    steepest = std::max(steepest, std::abs(corner(i ^ bit[a]) - corner(i)));
                max_slope += std::abs(r.along_[a]) * steepest;

                const std::size_t b = (a + 1) % 3;
                double twist = 0.0;
                for (std::size_t i = 0; i < 8; ++i)
                    twist = std::max(twist, std::abs(corner(i) - corner(i ^ bit[a]) - corner(i ^ bit[b]) +
                                                     corner(i ^ bit[a] ^ bit[b])));
                max_curvature += 2.0 * std::abs(r.along_[a] * r.along_[b]) * twist;
            }
        }

        Cell cell;
        double max_slope = 0.0;
        double max_curvature = 0.0;
    };

    void search(const Stretch& stretch, double low, double high)
    {
        const double at_low = value(stretch.cell, low);
        const double at_high = value(stretch.cell, high);
        const bool changes_side = (at_low >= 0.0) != (at_high >= 0.0);
        if (!changes_side && std::abs(at_low) + std::abs(at_high) > stretch.max_slope * (high - low))
            return;
        if (!changes_side && box_on_one_side(stretch.cell, low, high))
            return;
        const double middle = 0.5 * (low + high);
        const bool monotone =
            std::abs(slope(stretch.cell, middle)) > stretch.max_curvature * 0.5 * (high - low);
        if (monotone || (high - low) * length_ < kFinest)
        {
            if (changes_side)
                found_.push_back(bisect(stretch.cell, low, high));
            return;
        }
        search(stretch, low, middle);
        search(stretch, middle, high);
    }

    double bisect(const Cell& cell, double low, double high) const
    {
        const bool inside_low = value(cell, low) >= 0.0;
        while ((high - low) * length_ > 0.1 * kFinest)
        {
            const double middle = 0.5 * (low + high);
            ((value(cell, middle) >= 0.0) == inside_low ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    std::array<std::size_t, 3> size_;
    Vec3 spacing_;
    double sign_;
    std::vector<double> field_;
    Point3 source_;
    Vec3 along_;
    double length_ = 0.0;
    std::vector<double> found_;
};

} // namespace voroprobe
