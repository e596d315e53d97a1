#include "labels/label_survey.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "labels/part_groups.h"
#include "random_labels.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

template <class Sample>
Volume labels_of(const std::array<std::size_t, 3>& size, std::vector<Sample> samples)
{
    return make_volume({.size = size, .spacing = {1, 1, 1}, .direction = {}, .origin = {}},
                       std::move(samples));
}

TEST(LabelSurvey, counts_parts_as_a_flood_through_26_neighbours_does)
{
    for (std::uint64_t seed = 0; seed < 20; ++seed)
    {
        const std::array<std::size_t, 3> size{11, 9, 13};
        const Volume volume = random_labels(size, 5, seed);
        const auto& samples = std::get<std::vector<std::uint16_t>>(volume.samples);
        const LabelSurvey survey(volume);
        for (const SurveyedLabel& label : survey.labels())
        {
            std::vector<bool> belongs;
            for (const std::uint16_t sample : samples)
                belongs.push_back(sample == label.value);
            EXPECT_EQ(label.parts.size(), count_components(size, belongs, Neighbours::kAll)) << label.value;
            EXPECT_EQ(label.voxels,
                      static_cast<std::size_t>(std::count(belongs.begin(), belongs.end(), true)));
        }
    }
}

TEST(LabelSurvey, seventy_thousand_labels_are_each_there)
{
    constexpr std::int32_t kLabels = 70000;
    std::vector<std::int32_t> samples(84 * 84 * 84, 0);
    std::int32_t label = 0;
    for (std::size_t k = 0; k < 84; k += 2)
        for (std::size_t j = 0; j < 84; j += 2)
            for (std::size_t i = 0; i < 84 && label < kLabels; i += 2)
                samples[i + 84 * (j + 84 * k)] = ++label;
    const LabelSurvey survey(labels_of({84, 84, 84}, std::move(samples)));
    ASSERT_EQ(survey.labels().size(), std::size_t{kLabels});
    EXPECT_EQ(survey.parts().size(), std::size_t{kLabels});
    for (std::int32_t i = 0; i < kLabels; ++i)
        ASSERT_EQ(survey.labels()[static_cast<std::size_t>(i)].value, i + 1);
}

TEST(LabelSurvey, every_voxel_of_a_label_is_in_the_run_of_one_of_its_parts)
{
    const std::array<std::size_t, 3> size{11, 9, 13};
    const Volume volume = random_labels(size, 4, 7);
    const LabelSurvey survey(volume);
    std::size_t in_runs = 0;
    for (int k = 0; k < 13; ++k)
        for (int j = 0; j < 9; ++j)
            for (const LabelRun& run : survey.row(j, k))
                for (int i = run.first; i < run.end; ++i, ++in_runs)
                    EXPECT_EQ(survey.labels()[survey.parts()[run.part].label].value,
                              std::lround(volume.at(static_cast<std::size_t>(i), static_cast<std::size_t>(j),
                                                    static_cast<std::size_t>(k))));
    std::size_t in_labels = 0;
    for (const SurveyedLabel& label : survey.labels())
        in_labels += label.voxels;
    EXPECT_EQ(in_runs, in_labels);
}

TEST(LabelSurvey, voxels_that_share_a_corner_are_one_part_and_those_a_voxel_apart_are_two)
{
    const LabelSurvey survey(
        labels_of<std::uint8_t>({2, 2, 4}, {1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0}));
    ASSERT_EQ(survey.labels().size(), 1U);
    EXPECT_EQ(survey.labels()[0].parts.size(), 2U);
    EXPECT_EQ(survey.parts()[0].voxels, 2U);
}

TEST(LabelSurvey, takes_labels_of_every_type_and_refuses_what_is_no_whole_number)
{
    EXPECT_EQ(LabelSurvey(labels_of<float>({2, 2, 2}, {0, 0, 7, 7, -3, 0, 0, 0})).labels().size(), 2U);
    EXPECT_EQ(
        LabelSurvey(labels_of<double>({2, 2, 2}, {0, 0, 0, 0, 0, 0, 0, 4294967296.0})).labels()[0].value,
        4294967296);
    const auto message_of = [](double sample)
    {
        try
        {
            LabelSurvey(labels_of<double>({2, 2, 2}, {0, 0, 0, 0, 0, 0, sample, 1}));
        }
        catch (const InputError& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(message_of(0.25).find("index 0, 1, 1"), std::string::npos) << message_of(0.25);
    EXPECT_NE(message_of(0.25).find("whole numbers"), std::string::npos);
    EXPECT_NE(message_of(std::nan("")), "");
    EXPECT_NE(message_of(std::ldexp(1.0, 60)).find("2^53"), std::string::npos);
}

TEST(LabelSurvey, of_seventy_thousand_labels_each_is_listed)
{
    std::vector<std::int32_t> samples(70 * 100 * 10);
    std::iota(samples.begin(), samples.end(), 1);
    const LabelSurvey survey(labels_of<std::int32_t>({70, 100, 10}, std::move(samples)));
    EXPECT_EQ(survey.labels().size(), 70'000U);
    EXPECT_EQ(survey.parts().size(), 70'000U);
}

TEST(PartGroups, hold_every_part_once_and_those_next_to_each_other_together)
{
    const Volume volume = random_labels({30, 12, 12}, 3, 5);
    const LabelSurvey survey(volume);
    for (const SurveyedLabel& label : survey.labels())
    {
        const std::vector<PartGroup> groups = group_parts(survey, label);
        std::vector<std::uint32_t> grouped;
        for (const PartGroup& group : groups)
            grouped.insert(grouped.end(), group.parts.begin(), group.parts.end());
        std::sort(grouped.begin(), grouped.end());
        EXPECT_EQ(grouped, label.parts);
        for (const PartGroup& a : groups)
            for (const PartGroup& b : groups)
            {
                if (&a == &b)
                    continue;
                for (const std::uint32_t p : a.parts)
                    for (const std::uint32_t q : b.parts)
                        EXPECT_FALSE(survey.parts()[p].box.grown(1).meets(survey.parts()[q].box.grown(1)));
            }
    }
}

TEST(PartGroups, the_mask_holds_the_voxels_of_the_group_and_no_other)
{
    const Volume volume = random_labels({20, 12, 12}, 3, 9);
    const LabelSurvey survey(volume);
    for (const SurveyedLabel& label : survey.labels())
        for (const PartGroup& group : group_parts(survey, label))
        {
            const PartMask mask = cut_mask(survey, group);
            std::vector<std::size_t> voxels(group.parts.size(), 0);
            for (const std::uint32_t place : mask.part)
                if (place != 0)
                    ++voxels[place - 1];
            for (std::size_t i = 0; i < group.parts.size(); ++i)
                EXPECT_EQ(voxels[i], survey.parts()[group.parts[i]].voxels);
        }
}

} // namespace
} // namespace voroprobe
