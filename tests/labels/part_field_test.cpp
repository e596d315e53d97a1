#include "labels/part_field.h"

#include <cmath>

#include <gtest/gtest.h>

#include "labels/smoothing.h"
#include "random_labels.h"
#include "support/random.h"
#include "volume/inventory.h"
#include "volume/trilinear_cell.h"

namespace voroprobe
{
namespace
{

//! Voxels strewn at random, in a box with a margin, as one group: every part of it numbered.
PartMask random_mask(double share, std::uint64_t seed)
{
    const std::array<std::size_t, 3> size{12, 11, 10};
    Random random(seed);
    std::vector<std::uint8_t> samples;
    for (std::size_t i = 0; i < size[0] * size[1] * size[2]; ++i)
        samples.push_back(random.uniform() < share ? 1 : 0);
    const LabelSurvey survey(
        make_volume({.size = size, .spacing = {1, 1, 1}, .direction = {}, .origin = {}}, std::move(samples)));
    return cut_mask(survey, {survey.labels()[0].parts, survey.labels()[0].box});
}

std::vector<bool> side_of(const PartMask& mask, bool inside)
{
    std::vector<bool> side;
    for (const std::uint32_t part : mask.part)
        side.push_back((part != 0) == inside);
    return side;
}

std::vector<float> noise_of(const PartMask& mask, std::uint64_t seed)
{
    Random random(seed);
    std::vector<float> noise;
    for (std::size_t i = 0; i < mask.part.size(); ++i)
        noise.push_back(static_cast<float>(random.uniform(-0.5, 0.5)));
    return noise;
}

Inventory inventory_of(const Volume& volume)
{
    return Inventory(*make_height_field(level_volume(std::make_shared<const Volume>(volume), 0.0)));
}

//! Whatever the smoothed heights are.
TEST(PartField, has_the_parts_and_cavities_of_its_mask)
{
    for (std::uint64_t seed = 0; seed < 30; ++seed)
    {
        const PartMask mask = random_mask(seed % 2 == 0 ? 0.2 : 0.6, seed);
        const PartField field(mask, {1, 1, 1}, noise_of(mask, seed + 100));
        const Inventory inventory = inventory_of(field.volume());
        EXPECT_EQ(inventory.inside_region_count(),
                  count_components(mask.size, side_of(mask, true), Neighbours::kAll));
        EXPECT_EQ(inventory.outside_region_count(),
                  count_components(mask.size, side_of(mask, false), Neighbours::kFaces));
    }
}

TEST(PartField, keeps_every_sample_on_its_side_at_any_volume)
{
    const PartMask mask = random_mask(0.3, 3);
    PartField field(mask, {1, 1, 1}, noise_of(mask, 4));
    for (const double volume : {0.0, 0.5, 5.0, 1000.0})
    {
        field.fit_volumes(std::vector<double>(field.part_count(), volume));
        const auto heights = std::get<std::vector<float>>(field.volume().samples);
        for (std::size_t i = 0; i < heights.size(); ++i)
            EXPECT_EQ(heights[i] > 0.0F, mask.part[i] != 0);
    }
}

//! A ball of radius 4 is shrunk by a blur of 2 to a good deal less.
TEST(PartField, gives_a_part_the_volume_wanted)
{
    const std::array<std::size_t, 3> size{13, 13, 13};
    std::vector<std::uint8_t> samples;
    for (int k = -6; k <= 6; ++k)
        for (int j = -6; j <= 6; ++j)
            for (int i = -6; i <= 6; ++i)
                samples.push_back(i * i + j * j + k * k <= 16 ? 1 : 0);
    const LabelSurvey survey(
        make_volume({.size = size, .spacing = {1, 1, 2}, .direction = {}, .origin = {}}, std::move(samples)));
    const PartMask mask = cut_mask(survey, {survey.labels()[0].parts, survey.labels()[0].box});
    const std::vector<float> heights =
        smoothed_heights(mask, {1, 1, 2}, {.method = SmoothingMethod::kGaussian, .sigma = 2.0});
    PartField field(mask, {1, 1, 2}, heights);
    const double wanted = 2.0 * static_cast<double>(survey.labels()[0].voxels);
    EXPECT_GT(std::abs(field.volumes()[0] / wanted - 1.0), 0.02);
    field.fit_volumes(std::vector<double>{wanted});
    EXPECT_NEAR(field.volumes()[0], wanted, 0.002 * wanted);
}

//! The volume within half-space heights of a slanted plane, cut off by a mask that follows it.
TEST(PartField, measures_volumes_as_fine_sampling_does)
{
    const PartMask mask = random_mask(0.15, 11);
    const PartField field(mask, {1, 1, 1}, noise_of(mask, 12));
    const Volume volume = field.volume();
    constexpr int kFine = 12;
    double sampled = 0.0;
    const auto [columns, rows, slices] = mask.size;
    for (std::size_t k = 0; k + 1 < slices; ++k)
        for (std::size_t j = 0; j + 1 < rows; ++j)
            for (std::size_t i = 0; i + 1 < columns; ++i)
            {
                CellCorners corners{};
                for (std::size_t c = 0; c < 8; ++c)
                    corners[c] = volume.at(i + (c & 1U), j + (c >> 1U & 1U), k + (c >> 2U & 1U));
                for (int s = 0; s < kFine * kFine * kFine; ++s)
                    sampled += trilinear_value(corners,
                                               {(s % kFine + 0.5) / kFine, (s / kFine % kFine + 0.5) / kFine,
                                                (s / kFine / kFine + 0.5) / kFine}) >= 0.0;
            }
    sampled /= kFine * kFine * kFine;
    double measured = 0.0;
    for (const double part : field.volumes())
        measured += part;
    EXPECT_NEAR(measured, sampled, 0.01 * sampled);
}

TEST(PartField, counts_parts_that_smoothing_would_swallow)
{
    const LabelSurvey survey(
        make_volume({.size = {9, 3, 3}, .spacing = {1, 1, 1}, .direction = {}, .origin = {}},
                    []
                    {
                        std::vector<std::uint8_t> samples(81, 0);
                        samples[40] = 1; // one voxel in the middle
                        return samples;
                    }()));
    const PartMask mask = cut_mask(survey, {survey.labels()[0].parts, survey.labels()[0].box});
    const auto restored = [&](const LabelSmoothing& smoothing) {
        return PartField(mask, {1, 1, 1}, smoothed_heights(mask, {1, 1, 1}, smoothing)).parts_restored();
    };
    EXPECT_EQ(restored({.method = SmoothingMethod::kGaussian, .sigma = 1.0}), 1U);
    EXPECT_EQ(restored({.method = SmoothingMethod::kNone}), 0U);
}

} // namespace
} // namespace voroprobe
