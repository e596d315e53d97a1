//! Real label maps, where they are at hand: VOROPROBE_DATA, or ../shared/data beside the sources.

#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "io/volume_reader.h"
#include "labels/label_meshing.h"
#include "labels/label_survey.h"

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

} // namespace
} // namespace voroprobe
