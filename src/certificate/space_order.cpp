#include "certificate/space_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include <tbb/parallel_invoke.h>

namespace voroprobe
{
namespace
{

//! Runs of so many points are left as they are.
constexpr std::size_t kShortestRun = 4;

//! The halves of longer runs are ordered side by side.
constexpr std::size_t kShortForThreads = 8192;

//! So many points tell along which axis the others extend most.
constexpr std::size_t kMeasured = 64;

//! Floats decide on an order only.
struct Entry
{
    std::array<float, 3> at;
    std::uint32_t number;
};

//! Of some of them, at even steps.
std::size_t longest_axis(std::span<const Entry> entries)
{
    const std::size_t step = std::max<std::size_t>(1, entries.size() / kMeasured);
    std::array<float, 3> min = entries.front().at;
    std::array<float, 3> max = min;
    for (std::size_t i = step; i < entries.size(); i += step)
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            min[axis] = std::min(min[axis], entries[i].at[axis]);
            max[axis] = std::max(max[axis], entries[i].at[axis]);
        }
    const std::array<float, 3> extent{max[0] - min[0], max[1] - min[1], max[2] - min[2]};
    return static_cast<std::size_t>(std::max_element(extent.begin(), extent.end()) - extent.begin());
}

void order_by_halves(std::span<Entry> entries)
{
    if (entries.size() <= kShortestRun)
        return;
    const std::size_t axis = longest_axis(entries);
    const std::size_t half = std::bit_ceil(entries.size()) / 2;
    std::nth_element(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(half), entries.end(),
                     [axis](const Entry& a, const Entry& b) { return a.at[axis] < b.at[axis]; });
    const auto first = [&] { order_by_halves(entries.first(half)); };
    const auto second = [&] { order_by_halves(entries.subspan(half)); };
    if (entries.size() > kShortForThreads)
        return tbb::parallel_invoke(first, second);
    first();
    second();
}

} // namespace

std::vector<std::uint32_t> order_in_space(std::span<const Point3> points)
{
    std::vector<Entry> entries;
    entries.reserve(points.size());
    for (const Point3& p : points)
        entries.push_back({{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
                           static_cast<std::uint32_t>(entries.size())});
    order_by_halves(entries);
    std::vector<std::uint32_t> order;
    order.reserve(entries.size());
    for (const Entry& entry : entries)
        order.push_back(entry.number);
    return order;
}

} // namespace voroprobe
