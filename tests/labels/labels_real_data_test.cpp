//! Real label maps, where they are at hand: VOROPROBE_DATA, or ../shared/data beside the sources.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "io/volume_reader.h"
#include "labels/joint_meshing.h"
#include "labels/label_meshing.h"
#include "labels/label_survey.h"
#include "mesh/topology.h"

namespace voroprobe
{
namespace
{

struct KnownMap
{
    const char* file;
    std::size_t labels;
    std::size_t parts;
};

//! As others counted them, with 26 neighbours, when the maps were collected.
constexpr KnownMap kMaps[] = {{"inia19_labels.nii.gz", 724, 1307},
                              {"allen_labels.nii.gz", 138, 341},
                              {"frog_tissue_labels.mha", 25, 440},
                              {"platynereis_nuclei_labels.nrrd", 33, 33}};

std::filesystem::path path_of(const char* file)
{
    const char* folder = std::getenv("VOROPROBE_DATA");
    return std::filesystem::path(folder ? folder : VOROPROBE_SOURCE_DIR "/../shared/data") / file;
}

TEST(LabelsRealData, labels_and_parts_are_counted_as_others_did)
{
    for (const KnownMap& map : kMaps)
    {
        if (!std::filesystem::exists(path_of(map.file)))
            GTEST_SKIP() << "needs " << path_of(map.file);
        const LabelSurvey survey(read_volume(path_of(map.file)).volume);
        EXPECT_EQ(survey.labels().size(), map.labels) << map.file;
        EXPECT_EQ(survey.parts().size(), map.parts) << map.file;
    }
}

TEST(LabelsRealData, every_nucleus_is_meshed_with_its_volume)
{
    const char* file = "platynereis_nuclei_labels.nrrd";
    if (!std::filesystem::exists(path_of(file)))
        GTEST_SKIP() << "needs " << path_of(file);
    const Volume volume = read_volume(path_of(file)).volume;
    const LabelSurvey survey(volume);
    std::vector<std::uint32_t> places(survey.labels().size());
    for (std::uint32_t i = 0; i < places.size(); ++i)
        places[i] = i;
    std::size_t meshed = 0;
    mesh_labels(survey, places, volume.geometry.spacing,
                {.criteria = {.max_facet_radius = 2.0,
                              .max_facet_distance = 0.3,
                              .floor_radius = 0.25,
                              .reach_lower_bound = 1.0},
                 .smoothing = {.method = SmoothingMethod::kAntialias}},
                0, nullptr,
                [&](const LabelMesh& label)
                {
                    ++meshed;
                    EXPECT_TRUE(label.complete());
                    EXPECT_LT(std::abs(label.volume_change()), 0.02);
                });
    EXPECT_EQ(meshed, 33U);
}

class WholeMap : public testing::TestWithParam<KnownMap>
{
protected:
    void SetUp() override
    {
        const std::filesystem::path path = path_of(GetParam().file);
        if (!std::filesystem::exists(path))
            GTEST_SKIP() << "needs " << path;
        const Volume volume = read_volume(path).volume;
        survey_.emplace(volume);
        spacing_ = volume.geometry.spacing;
        places_.resize(survey_->labels().size());
        std::iota(places_.begin(), places_.end(), 0);
    }

    //! As `voroprobe mesh --labels all` chooses them.
    [[nodiscard]] MeshingOptions criteria() const
    {
        const double shortest = std::min({spacing_.x, spacing_.y, spacing_.z});
        return {.max_facet_radius = 2.0 * std::cbrt(spacing_.x * spacing_.y * spacing_.z),
                .max_facet_distance = 0.3 * shortest,
                .floor_radius = 0.25 * shortest,
                .reach_lower_bound = shortest};
    }

    void expect_whole(const LabelMesh& label)
    {
        EXPECT_TRUE(label.complete());
        EXPECT_EQ(label.parts_meshed, survey_->labels()[label.label].parts.size());
        EXPECT_LT(std::abs(label.volume_change()), 0.02);
        EXPECT_EQ(analyze_topology(label.mesh).boundary_edges, 0U);
        parts_ += label.parts_meshed;
        cavities_expected_ += label.cavities_expected;
        cavities_meshed_ += label.cavities_meshed;
    }

    std::optional<LabelSurvey> survey_;
    Vec3 spacing_;
    std::vector<std::uint32_t> places_;
    std::size_t parts_ = 0;
    std::size_t cavities_expected_ = 0;
    std::size_t cavities_meshed_ = 0;
};

TEST_P(WholeMap, has_every_part_and_cavity_of_every_label_with_its_volume)
{
    mesh_labels(
        *survey_, places_, spacing_,
        {.criteria = criteria(),
         .smoothing = {.method = SmoothingMethod::kGaussian, .sigma = 0.5 * criteria().max_facet_radius}},
        0, nullptr, [&](const LabelMesh& label) { expect_whole(label); });
    EXPECT_EQ(parts_, GetParam().parts);
    EXPECT_EQ(cavities_meshed_, cavities_expected_);
}

TEST_P(WholeMap, has_every_part_with_its_volume_and_nearly_every_cavity_where_interfaces_are_shared)
{
    mesh_labels_jointly(*survey_, places_, spacing_, criteria(), nullptr,
                        [&](const LabelMesh& label) { expect_whole(label); });
    EXPECT_EQ(parts_, GetParam().parts);
    EXPECT_LE(cavities_meshed_, cavities_expected_);
    EXPECT_GE(static_cast<double>(cavities_meshed_), 0.98 * static_cast<double>(cavities_expected_));
}

INSTANTIATE_TEST_SUITE_P(Nightly, WholeMap, testing::ValuesIn(kMaps),
                         [](const auto& map)
                         {
                             const std::string file = map.param.file;
                             return file.substr(0, file.find('_'));
                         });

} // namespace
} // namespace voroprobe
