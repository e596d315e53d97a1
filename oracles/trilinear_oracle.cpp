#include "oracles/trilinear_oracle.h"

#include <string>
#include <utility>

#include "oracles/brick_map.h"
#include "oracles/lattice_oracle.h"
#include "support/error.h"
#include "volume/level.h"

namespace voroprobe
{
namespace
{

//! The samples of a volume as a field, with the bricks that tell where its surface is.
template <class Sample>
class DenseLattice
{
public:
    DenseLattice(std::shared_ptr<const Volume> volume, const Level& level)
        : volume_(std::move(volume)), samples_(std::get<std::vector<Sample>>(volume_->samples).data()),
          level_(level), row_stride_(volume_->geometry.size[0]),
          slice_stride_(row_stride_ * volume_->geometry.size[1]),
          bricks_(volume_->geometry.size,
                  [this](std::size_t k, std::span<std::uint8_t> sides)
                  {
                      // Local variables, for the loop to be done with vectors.
                      const Level level_here = level_;
                      const Sample* slice = samples_ + k * slice_stride_;
                      std::uint8_t* side = sides.data();
                      const std::size_t count = sides.size();
                      for (std::size_t i = 0; i < count; ++i)
                          side[i] = level_here(static_cast<double>(slice[i])) >= 0.0 ? 1 : 0;
                  })
    {
    }

    [[nodiscard]] LatticeFrame frame() const
    {
        const auto& size = volume_->geometry.size;
        return {{static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2])},
                volume_->geometry.spacing,
                {0, 0, 0}};
    }

    [[nodiscard]] const DenseLattice& reader() const { return *this; }

    [[nodiscard]] CellCorners corners(const GridCell& cell) const
    {
        const Sample* low = first_corner(cell);
        const Sample* high = low + slice_stride_;
        return {value(low),  value(low + 1),  value(low + row_stride_),  value(low + row_stride_ + 1),
                value(high), value(high + 1), value(high + row_stride_), value(high + row_stride_ + 1)};
    }

    [[nodiscard]] bool is_first_corner_inside(const GridCell& cell) const { return bricks_.is_inside(cell); }

    [[nodiscard]] bool is_mixed(const GridCell& cell) const { return bricks_.is_mixed(cell); }

    [[nodiscard]] std::optional<GridCellBox> clear_box(const GridCell& cell) const
    {
        const int distance = bricks_.distance(cell);
        return distance > 0 ? std::optional(BrickMap::clear_box(cell, distance)) : std::nullopt;
    }

    [[nodiscard]] bool any_mixed(const GridCellBox& box) const { return bricks_.any_mixed(box); }

private:
    [[nodiscard]] double value(const Sample* sample) const { return level_(static_cast<double>(*sample)); }

    [[nodiscard]] const Sample* first_corner(const GridCell& cell) const
    {
        return samples_ +
               (static_cast<std::size_t>(cell[0]) + static_cast<std::size_t>(cell[1]) * row_stride_ +
                static_cast<std::size_t>(cell[2]) * slice_stride_);
    }

    std::shared_ptr<const Volume> volume_;
    const Sample* samples_;
    Level level_;
    std::size_t row_stride_;
    std::size_t slice_stride_;
    BrickMap bricks_;
};

void check_inventory(const LevelledVolume& levelled, const std::shared_ptr<const Inventory>& inventory)
{
    if (!levelled.volume)
        throw UsageError("trilinear oracle: no volume");
    if (!inventory)
        return;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (static_cast<std::size_t>(inventory->runs().sample_count()[axis]) !=
            levelled.volume->geometry.size[axis])
            throw UsageError("trilinear oracle: inventory of " +
                             std::to_string(inventory->runs().sample_count()[axis]) + " samples along axis " +
                             std::to_string(axis) + ", expected " +
                             std::to_string(levelled.volume->geometry.size[axis]) + " as in the volume");
}

} // namespace

std::unique_ptr<SurfaceOracle> make_trilinear_oracle(std::shared_ptr<const Volume> volume, double isovalue,
                                                     InsideIs inside)
{
    return make_trilinear_oracle(level_volume(std::move(volume), isovalue, inside), nullptr);
}

std::unique_ptr<SurfaceOracle> make_trilinear_oracle(const LevelledVolume& levelled,
                                                     std::shared_ptr<const Inventory> inventory)
{
    check_inventory(levelled, inventory);
    LatticeRegions regions;
    if (inventory)
        regions = {std::move(inventory), make_height_field(levelled)};
    return std::visit(
        [&]<class Sample>(const std::vector<Sample>&) -> std::unique_ptr<SurfaceOracle>
        {
            return std::make_unique<LatticeOracle<DenseLattice<Sample>>>(
                DenseLattice<Sample>(levelled.volume, levelled.level), std::move(regions));
        },
        levelled.volume->samples);
}

} // namespace voroprobe
