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
                      for (std::size_t i = 0; i < sides.size(); ++i)
                          sides[i] = value(samples_ + k * slice_stride_ + i) >= 0.0;
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

//! The volume with samples that are not finite replaced by a value outside.
template <class Sample>
std::shared_ptr<const Volume> with_finite_samples(const Volume& volume, double outside)
{
    auto copy = std::make_shared<Volume>(volume);
    for (Sample& sample : std::get<std::vector<Sample>>(copy->samples))
        if (!std::isfinite(static_cast<double>(sample)))
            sample = static_cast<Sample>(outside);
    return copy;
}

void check_volume(const std::shared_ptr<const Volume>& volume, double isovalue)
{
    if (!volume)
        throw UsageError("trilinear oracle: no volume");
    if (!std::isfinite(isovalue))
        throw UsageError("trilinear oracle: isovalue " + std::to_string(isovalue) +
                         ", expected a finite number");
    for (const std::size_t size : volume->geometry.size)
        if (size < 2 || size > static_cast<std::size_t>(std::numeric_limits<int>::max()))
            throw UsageError("trilinear oracle: " + std::to_string(size) +
                             " samples along an axis, expected at least 2 and fewer than 2^31");
    const std::size_t count = std::visit([](const auto& samples) { return samples.size(); }, volume->samples);
    if (count != volume->geometry.sample_count())
        throw UsageError("trilinear oracle: " + std::to_string(count) + " samples, expected " +
                         std::to_string(volume->geometry.sample_count()));
}

} // namespace

std::unique_ptr<SurfaceOracle> make_trilinear_oracle(std::shared_ptr<const Volume> volume, double isovalue,
                                                     InsideIs inside)
{
    check_volume(volume, isovalue);
    return std::visit(
        [&]<class Sample>(const std::vector<Sample>& samples) -> std::unique_ptr<SurfaceOracle>
        {
            LevelSurvey survey(isovalue, inside);
            for (const Sample sample : samples)
                survey.include(static_cast<double>(sample));
            if (survey.not_finite() > 0)
                volume = with_finite_samples<Sample>(*volume, survey.outside());
            return std::make_unique<LatticeOracle<DenseLattice<Sample>>>(
                DenseLattice<Sample>(volume, survey.level()));
        },
        volume->samples);
}

} // namespace voroprobe
