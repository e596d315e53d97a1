#include "mesher/probing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace voroprobe
{
namespace
{

//! The axes of a box, longest first.
std::array<std::size_t, 3> axes_by_length(const Box3& box)
{
    std::array<std::size_t, 3> axes{0, 1, 2};
    const Vec3 extent = box.extent();
    std::stable_sort(axes.begin(), axes.end(),
                     [&](std::size_t a, std::size_t b) { return extent[a] > extent[b]; });
    return axes;
}

//! Probes of one box along its longest side through the nodes of a lattice that is halved level by level, so
//! that each probe lies where the earlier ones are farthest.
class BoxProbing
{
public:
    BoxProbing(const SurfaceOracle& oracle, double spacing, std::size_t& query_count)
        : oracle_(oracle), box_(oracle.domain()), axes_(axes_by_length(box_)), query_count_(query_count)
    {
        // Every point of a square lattice cell is within half its diagonal of a node.
        const double side = std::numbers::sqrt2 * spacing;
        const double longer = box_.extent()[axes_[1]];
        while (longer / static_cast<double>(std::size_t{1} << levels_) > side)
            ++levels_;
    }

    std::optional<Point3> run()
    {
        if (box_.empty() || !oracle_.may_cross(box_))
            return std::nullopt;
        for (std::size_t level = 1; level <= std::max<std::size_t>(levels_, 1); ++level)
        {
            if (const auto hit = probe_level(level))
                return hit;
        }
        return std::nullopt;
    }

private:
    // The nodes of this level that are on no coarser one. The box's own sides come with the last level only:
    // they are the least likely place.
    std::optional<Point3> probe_level(std::size_t level)
    {
        const std::size_t count = std::size_t{1} << level;
        const std::size_t border = level == levels_ ? 0 : 1;
        for (std::size_t i = border; i <= count - border; ++i)
        {
            for (std::size_t j = border; j <= count - border; ++j)
            {
                const bool on_side = i == 0 || j == 0 || i == count || j == count;
                const bool probed_before = !on_side && i % 2 == 0 && j % 2 == 0;
                if (probed_before && level > 1)
                    continue;
                const double step = 1.0 / static_cast<double>(count);
                if (const auto hit = probe(static_cast<double>(i) * step, static_cast<double>(j) * step))
                    return hit;
            }
        }
        return std::nullopt;
    }

    //! One probe through the box at fractions (u, v) of its two shorter sides.
    std::optional<Point3> probe(double u, double v)
    {
        Segment3 segment{box_.min, box_.max};
        for (const auto& [axis, fraction] : {std::pair{axes_[1], u}, std::pair{axes_[2], v}})
        {
            segment.source[axis] = box_.min[axis] + fraction * box_.extent()[axis];
            segment.target[axis] = segment.source[axis];
        }
        ++query_count_;
        oracle_.find_crossings(segment, crossings_);
        if (crossings_.empty())
            return std::nullopt;
        return crossings_.front().point;
    }

    const SurfaceOracle& oracle_;
    Box3 box_;
    std::array<std::size_t, 3> axes_;
    std::size_t levels_ = 0;
    std::size_t& query_count_;
    std::vector<Crossing> crossings_;
};

} // namespace

std::optional<Point3> probe_domain(const SurfaceOracle& oracle, double spacing, std::size_t& query_count)
{
    return BoxProbing(oracle, spacing, query_count).run();
}

} // namespace voroprobe
