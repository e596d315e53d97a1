#include "mesher/probing.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "support/error.h"

namespace voroprobe
{
namespace
{

// Finer lattices would take hours: 2^14 nodes along a side.
constexpr std::size_t kMostLevels = 14;

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
        for (std::size_t a = 0; a < 2; ++a)
        {
            const double length = box_.extent()[axes_[a + 1]];
            while (length > side * static_cast<double>(std::size_t{1} << levels_[a]))
            {
                if (++levels_[a] > kMostLevels)
                    throw UsageError("reach_lower_bound is " + std::to_string(spacing) +
                                     "; it must be at least " +
                                     std::to_string(length / static_cast<double>(1U << kMostLevels)) +
                                     " for a domain of this size");
            }
        }
    }

    std::optional<Point3> run()
    {
        if (box_.empty() || !oracle_.may_cross(box_))
            return std::nullopt;
        for (std::size_t level = 1; level <= last_level(); ++level)
        {
            if (const auto hit = probe_level(level))
                return hit;
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] std::size_t last_level() const
    {
        return std::max({levels_[0], levels_[1], std::size_t{1}});
    }

    //! Steps of the lattice along a shorter side at a level; a side is halved no further than it needs.
    [[nodiscard]] std::size_t steps(std::size_t side, std::size_t level) const
    {
        return std::size_t{1} << std::min(level, std::max(levels_[side], std::size_t{1}));
    }

    // The nodes of this level that are on no coarser one. The box's own sides come with the last level only:
    // they are the least likely place.
    std::optional<Point3> probe_level(std::size_t level)
    {
        const std::size_t nu = steps(0, level);
        const std::size_t nv = steps(1, level);
        const std::size_t u_ratio =
            nu / steps(0, level - 1); // 1 or 2; a level 0 of one step has the sides only
        const std::size_t v_ratio = nv / steps(1, level - 1);
        const std::size_t border = level == last_level() ? 0 : 1;
        for (std::size_t i = border; i <= nu - border; ++i)
        {
            for (std::size_t j = border; j <= nv - border; ++j)
            {
                const bool on_side = i == 0 || j == 0 || i == nu || j == nv;
                if (level > 1 && !on_side && i % u_ratio == 0 && j % v_ratio == 0)
                    continue; // probed before
                if (const auto hit = probe(static_cast<double>(i) / static_cast<double>(nu),
                                           static_cast<double>(j) / static_cast<double>(nv)))
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
    std::array<std::size_t, 2> levels_{}; //!< halvings that the two shorter sides need
    std::size_t& query_count_;
    std::vector<Crossing> crossings_;
};

} // namespace

std::optional<Point3> probe_domain(const SurfaceOracle& oracle, double spacing, std::size_t& query_count)
{
    return BoxProbing(oracle, spacing, query_count).run();
}

} // namespace voroprobe
