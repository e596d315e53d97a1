#include "oracles/brick_map.h"

#include <limits>

#include "support/check.h"

namespace voroprobe
{
namespace
{

//! For each grid cell of a layer between two slices, or of one slice alone: does an inside, an outside corner
//! occur?
struct CornerSides
{
    explicit CornerSides(std::size_t count) : any_inside(count), any_outside(count) {}

    std::vector<std::uint8_t> any_inside;
    std::vector<std::uint8_t> any_outside;
};

//! The four corners each grid cell has in one slice.
void gather_slice(std::span<const std::uint8_t> sides, std::size_t nx, std::size_t ny, CornerSides& corners)
{
    for (std::size_t j = 0; j + 1 < ny; ++j)
    {
        const std::uint8_t* row = sides.data() + j * nx;
        std::uint8_t* any_inside = corners.any_inside.data() + j * nx;
        std::uint8_t* any_outside = corners.any_outside.data() + j * nx;
        for (std::size_t i = 0; i + 1 < nx; ++i)
        {
            any_inside[i] = row[i] | row[i + 1] | row[i + nx] | row[i + nx + 1];
            any_outside[i] = (row[i] & row[i + 1] & row[i + nx] & row[i + nx + 1]) ^ 1U;
        }
    }
}

constexpr int kFarthest = std::numeric_limits<std::uint8_t>::max();

} // namespace

BrickMap::BrickMap(const std::array<std::size_t, 3>& sample_count, const SliceSides& sides_of_slice)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        CHECK_GE(sample_count[axis], 2U);
        brick_count_[axis] = static_cast<int>((sample_count[axis] - 1 + kSide - 1) / kSide);
    }
    row_stride_ = static_cast<std::size_t>(brick_count_[0]);
    slice_stride_ = row_stride_ * static_cast<std::size_t>(brick_count_[1]);
    bricks_.resize(slice_stride_ * static_cast<std::size_t>(brick_count_[2]));
    mark_mixed(sample_count, sides_of_slice);
    compute_distances();
}

void BrickMap::mark_mixed(const std::array<std::size_t, 3>& sample_count, const SliceSides& sides_of_slice)
{
    const auto [nx, ny, nz] = sample_count;
    std::vector<std::uint8_t> sides(nx * ny);
    CornerSides below(nx * ny);
    CornerSides above(nx * ny);
    sides_of_slice(0, sides);
    gather_slice(sides, nx, ny, below);
    for (std::size_t k = 0; k + 1 < nz; ++k)
    {
        sides_of_slice(k + 1, sides);
        gather_slice(sides, nx, ny, above);
        for (std::size_t j = 0; j + 1 < ny; ++j)
            for (std::size_t i = 0; i + 1 < nx; ++i)
            {
                const std::size_t at = i + j * nx;
                const std::uint64_t any_inside = below.any_inside[at] | above.any_inside[at];
                const std::uint64_t any_outside = below.any_outside[at] | above.any_outside[at];
                const GridCell cell{static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)};
                Brick& brick = bricks_[brick_of(cell)];
                brick.mixed |= (any_inside & any_outside) << bit_of(cell);
                brick.inside |= any_inside << bit_of(cell);
            }
        std::swap(below, above);
    }
}

// Two passes over the bricks with the 13 neighbours before and after each are exact for the Chebyshev
// distance. Source: Rosenfeld & Pfaltz 1968.
void BrickMap::compute_distances()
{
    distances_.resize(bricks_.size());
    for (std::size_t b = 0; b < bricks_.size(); ++b)
        distances_[b] = bricks_[b].mixed != 0 ? 0 : kFarthest;

    const auto [nx, ny, nz] = brick_count_;
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                relax_distance({x, y, z}, Neighbours::kBefore);
    for (int z = nz - 1; z >= 0; --z)
        for (int y = ny - 1; y >= 0; --y)
            for (int x = nx - 1; x >= 0; --x)
                relax_distance({x, y, z}, Neighbours::kAfter);
}

void BrickMap::relax_distance(const std::array<int, 3>& brick, Neighbours neighbours)
{
    const auto index = [&](const std::array<int, 3>& b)
    {
        return static_cast<std::size_t>(b[0]) + static_cast<std::size_t>(b[1]) * row_stride_ +
               static_cast<std::size_t>(b[2]) * slice_stride_;
    };
    const int direction = neighbours == Neighbours::kBefore ? 1 : -1;
    int nearest = distances_[index(brick)];
    for (int dz = -1; dz <= 0; ++dz)
        for (int dy = -1; dy <= (dz == 0 ? 0 : 1); ++dy)
            for (int dx = -1; dx <= (dz == 0 && dy == 0 ? -1 : 1); ++dx)
            {
                const std::array<int, 3> other{brick[0] + direction * dx, brick[1] + direction * dy,
                                               brick[2] + direction * dz};
                bool in_grid = true;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    in_grid = in_grid && other[axis] >= 0 && other[axis] < brick_count_[axis];
                if (in_grid)
                    nearest = std::min(nearest, distances_[index(other)] + 1);
            }
    distances_[index(brick)] = static_cast<std::uint8_t>(nearest);
}

bool BrickMap::any_mixed(const GridCellBox& box) const
{
    // Strides of one brick; within it, all grid cells of the box.
    for (int z = box.min[2]; z <= box.max[2]; z = (z | (kSide - 1)) + 1)
        for (int y = box.min[1]; y <= box.max[1]; y = (y | (kSide - 1)) + 1)
            for (int x = box.min[0]; x <= box.max[0]; x = (x | (kSide - 1)) + 1)
            {
                const std::uint64_t mask = bricks_[brick_of({x, y, z})].mixed;
                if (mask == 0)
                    continue;
                for (int k = z; k <= std::min(z | (kSide - 1), box.max[2]); ++k)
                    for (int j = y; j <= std::min(y | (kSide - 1), box.max[1]); ++j)
                        for (int i = x; i <= std::min(x | (kSide - 1), box.max[0]); ++i)
                            if ((mask >> bit_of({i, j, k}) & 1U) != 0)
                                return true;
            }
    return false;
}

} // namespace voroprobe
