#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "oracles/grid_walk.h"
#include "volume/region_runs.h"

namespace voroprobe
{

//! The regions met in bricks of 4x4x4 grid cells: nearly always at most one inside and one outside, so that
//! the side of a point tells its region. Memory: 8 bytes per brick, one bit per sample.
class RegionBricks
{
public:
    //! What only_region() answers where a brick holds several regions of the side.
    static constexpr Region kSeveral = 0;

    //! Cost: proportional to the runs and to the bricks along the rows.
    explicit RegionBricks(const RegionRuns& runs);

    //! The region of all samples of one side in the brick of a grid cell; kSeveral where they differ.
    [[nodiscard]] Region only_region(const GridCell& cell, bool inside) const
    {
        return bricks_[brick_of(cell)][inside ? 1 : 0];
    }

private:
    static constexpr int kLog2Side = 2;

    //! Outside, inside.
    using Brick = std::array<Region, 2>;

    [[nodiscard]] std::size_t brick_of(const GridCell& cell) const
    {
        return static_cast<std::size_t>(cell[0] >> kLog2Side) +
               static_cast<std::size_t>(cell[1] >> kLog2Side) * row_stride_ +
               static_cast<std::size_t>(cell[2] >> kLog2Side) * slice_stride_;
    }

    void note_row(const RegionRuns& runs, int j, int k);

    std::array<int, 3> brick_count_{};
    std::size_t row_stride_ = 0;
    std::size_t slice_stride_ = 0;
    std::vector<Brick> bricks_;
};

} // namespace voroprobe
