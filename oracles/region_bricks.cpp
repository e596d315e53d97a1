#include "oracles/region_bricks.h"

#include <algorithm>
#include <limits>

namespace voroprobe
{
namespace
{

//! No region yet.
constexpr Region kUnseen = std::numeric_limits<Region>::min();

//! First and last of the grid cells that have a sample as a corner, along one axis; as bricks.
struct BrickRange
{
    int first;
    int last;
};

} // namespace

RegionBricks::RegionBricks(const RegionRuns& runs)
{
    const auto [columns, rows, slices] = runs.sample_count();
    for (std::size_t axis = 0; axis < 3; ++axis)
        brick_count_[axis] = ((runs.sample_count()[axis] - 2) >> kLog2Side) + 1;
    row_stride_ = static_cast<std::size_t>(brick_count_[0]);
    slice_stride_ = row_stride_ * static_cast<std::size_t>(brick_count_[1]);
    bricks_.resize(slice_stride_ * static_cast<std::size_t>(brick_count_[2]), {kUnseen, kUnseen});
    for (int k = 0; k < slices; ++k)
        for (int j = 0; j < rows; ++j)
            note_row(runs, j, k);
}

void RegionBricks::note_row(const RegionRuns& runs, int j, int k)
{
    const std::array<int, 3>& size = runs.sample_count();
    // The bricks of the grid cells before the first and after the last of some samples along an axis.
    const auto bricks_at = [&](std::size_t axis, int first_sample, int last_sample) -> BrickRange {
        return {std::max(first_sample - 1, 0) >> kLog2Side,
                std::min(last_sample, size[axis] - 2) >> kLog2Side};
    };
    const BrickRange y = bricks_at(1, j, j);
    const BrickRange z = bricks_at(2, k, k);
    const std::span<const Run> row = runs.row(j, k);
    for (std::size_t r = 0; r < row.size(); ++r)
    {
        const int last = r + 1 < row.size() ? row[r + 1].first - 1 : size[0] - 1;
        const BrickRange x = bricks_at(0, row[r].first, last);
        for (int bz = z.first; bz <= z.last; ++bz)
            for (int by = y.first; by <= y.last; ++by)
                for (int bx = x.first; bx <= x.last; ++bx)
                {
                    Brick& brick =
                        bricks_[static_cast<std::size_t>(bx) + static_cast<std::size_t>(by) * row_stride_ +
                                static_cast<std::size_t>(bz) * slice_stride_];
                    Region& seen = brick[is_inside(row[r].region) ? 1 : 0];
                    seen = seen == kUnseen || seen == row[r].region ? row[r].region : kSeveral;
                }
    }
}

} // namespace voroprobe
