#include "volume/height_field.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "support/check.h"
#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

//! Largest difference of a sample from the isovalue: products of several differences stay finite, and so do
//! those of 32-bit floats.
constexpr double kFarthest = 1e60;

void check_volume(const std::shared_ptr<const Volume>& volume, double isovalue)
{
    if (!volume)
        throw UsageError("level of a volume: no volume");
    if (!std::isfinite(isovalue))
        throw UsageError("level of a volume: isovalue " + std::to_string(isovalue) +
                         ", expected a finite number");
    for (const std::size_t size : volume->geometry.size)
        if (size < 2 || size > static_cast<std::size_t>(std::numeric_limits<int>::max()))
            throw UsageError("level of a volume: " + std::to_string(size) +
                             " samples along an axis, expected at least 2 and fewer than 2^31");
    const std::size_t count = std::visit([](const auto& samples) { return samples.size(); }, volume->samples);
    if (count != volume->geometry.sample_count())
        throw UsageError("level of a volume: " + std::to_string(count) + " samples, expected " +
                         std::to_string(volume->geometry.sample_count()));
}

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

//! The samples of a volume where they are.
class DenseHeightField final : public HeightField
{
public:
    explicit DenseHeightField(LevelledVolume levelled) : levelled_(std::move(levelled)) {}

    [[nodiscard]] LatticeFrame frame() const override
    {
        const auto& size = levelled_.volume->geometry.size;
        return {{static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2])},
                levelled_.volume->geometry.spacing,
                {0, 0, 0}};
    }

    void read_slice(std::size_t k, std::span<double> heights) const override
    {
        const auto& size = levelled_.volume->geometry.size;
        CHECK_EQ(heights.size(), size[0] * size[1]);
        CHECK_LT(k, size[2]);
        std::visit(
            [&](const auto& samples)
            {
                const Level level = levelled_.level; // a local variable, for the loop to be done with vectors
                const auto* sample = samples.data() + k * heights.size();
                for (double& height : heights)
                    height = level(static_cast<double>(*sample++));
            },
            levelled_.volume->samples);
    }

private:
    LevelledVolume levelled_;
};

} // namespace

LevelledVolume level_volume(std::shared_ptr<const Volume> volume, double isovalue, InsideIs inside)
{
    check_volume(volume, isovalue);
    return std::visit(
        [&]<class Sample>(const std::vector<Sample>& samples) -> LevelledVolume
        {
            LevelSurvey survey(isovalue, inside);
            for (const Sample sample : samples)
                survey.include(static_cast<double>(sample));
            if (survey.farthest() > kFarthest)
                throw InputError("samples differ from the isovalue by up to " +
                                 number_text(survey.farthest()) + ", allowed is " + number_text(kFarthest) +
                                 ": samples without a value are better NaN");
            if (survey.not_finite() > 0)
                volume = with_finite_samples<Sample>(*volume, survey.outside());
            return {volume, survey.level()};
        },
        volume->samples);
}

std::unique_ptr<HeightField> make_height_field(LevelledVolume levelled)
{
    return std::make_unique<DenseHeightField>(std::move(levelled));
}

} // namespace voroprobe
