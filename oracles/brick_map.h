#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "oracles/grid_walk.h"

namespace voroprobe
{

//! Which grid cells of a volume hold surface, in bricks of 4x4x4 grid cells that know how far the nearest
//! such brick is. A grid cell is *mixed* where its corners do not all lie on one side. Memory: 17 bytes per
//! brick, 2.1 bits per sample.
class BrickMap
{
public:
    //! Writes 1 for each sample of slice k that lies inside and 0 for each outside, x fastest.
    using SliceSides = std::function<void(std::size_t k, std::span<std::uint8_t> sides)>;

    //! \pre At least two samples along each axis. Cost: one pass over the samples.
    BrickMap(const std::array<std::size_t, 3>& sample_count, const SliceSides& sides_of_slice);

    [[nodiscard]] bool is_mixed(const GridCell& cell) const
    {
        return (bricks_[brick_of(cell)].mixed >> bit_of(cell) & 1U) != 0;
    }

    //! The side of a grid cell all of whose corners lie on it. \pre It is not mixed.
    [[nodiscard]] bool is_inside(const GridCell& cell) const
    {
        return (bricks_[brick_of(cell)].inside >> bit_of(cell) & 1U) != 0;
    }

    //! Distance from the brick of the grid cell to the nearest with a mixed grid cell: 0 for such a brick, 1
    //! for its 26 neighbours and so on; capped at 255.
    [[nodiscard]] int distance(const GridCell& cell) const { return distances_[brick_of(cell)]; }

    //! The bricks nearer than distance(cell) to that of the grid cell: none of their grid cells is mixed. It
    //! may reach beyond the grid. \pre distance(cell) > 0.
    [[nodiscard]] static GridCellBox clear_box(const GridCell& cell, int distance)
    {
        GridCellBox box{};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const int brick = cell[axis] >> kLog2Side;
            box.min[axis] = (brick - distance + 1) * kSide;
            box.max[axis] = (brick + distance) * kSide - 1;
        }
        return box;
    }

    //! Is there a mixed grid cell in the box? \pre The box lies in the grid.
    [[nodiscard]] bool any_mixed(const GridCellBox& box) const;

    [[nodiscard]] std::size_t memory_bytes() const
    {
        return bricks_.size() * sizeof(Brick) + distances_.size();
    }

private:
    static constexpr int kLog2Side = 2;
    static constexpr int kSide = 1 << kLog2Side; //!< grid cells: their 4^3 bits fill one word

    //! Bit x + 4 y + 16 z speaks of the brick's grid cell (x, y, z). One fetch serves both questions.
    struct Brick
    {
        std::uint64_t mixed = 0;
        std::uint64_t inside = 0; //!< some corner is inside
    };

    [[nodiscard]] std::size_t brick_of(const GridCell& cell) const
    {
        return static_cast<std::size_t>(cell[0] >> kLog2Side) +
               static_cast<std::size_t>(cell[1] >> kLog2Side) * row_stride_ +
               static_cast<std::size_t>(cell[2] >> kLog2Side) * slice_stride_;
    }
    [[nodiscard]] static unsigned bit_of(const GridCell& cell)
    {
        return static_cast<unsigned>((cell[0] & (kSide - 1)) | (cell[1] & (kSide - 1)) << kLog2Side |
                                     (cell[2] & (kSide - 1)) << 2 * kLog2Side);
    }

    void mark_mixed(const std::array<std::size_t, 3>& sample_count, const SliceSides& sides_of_slice);
    void compute_distances();

    //! Those that come before a brick in memory, or after it.
    enum class Neighbours
    {
        kBefore,
        kAfter
    };
    void relax_distance(const std::array<int, 3>& brick, Neighbours neighbours);

    std::array<int, 3> brick_count_{};
    std::size_t row_stride_ = 0;
    std::size_t slice_stride_ = 0;
    std::vector<Brick> bricks_;
    std::vector<std::uint8_t> distances_;
};

} // namespace voroprobe
