#include "io/nrrd_segments.h"

#include <fstream>

#include <gtest/gtest.h>

#include "io/volume_reader.h"
#include "support/error.h"
#include "temporary_folder.h"
#include "volume_files.h"

namespace voroprobe
{
namespace
{

class NrrdSegments : public testing::Test
{
protected:
    std::filesystem::path file_of(const std::vector<std::string>& fields, const std::string& samples)
    {
        const std::filesystem::path path = folder_.path() / "s.seg.nrrd";
        std::ofstream(path, std::ios::binary) << nrrd_of(fields, samples);
        return path;
    }

    //! 2 x 3 x 2 voxels, two layers: sample i holds i in layer 0 and 100 + i in layer 1.
    std::filesystem::path two_layers()
    {
        std::string samples;
        for (char i = 0; i < 12; ++i)
            samples += {i, static_cast<char>(100 + i)};
        return file_of({"type: unsigned char", "dimension: 4", "space: left-posterior-superior",
                        "sizes: 2 2 3 2", "space directions: none (1,0,0) (0,1,0) (0,0,2)",
                        "kinds: list domain domain domain", "encoding: raw", "space origin: (0,0,0)",
                        "Segment0_Name:=left: kidney", "Segment0_LabelValue:=3", "Segment0_Layer:=1",
                        "Segment0_Color:=1 0.2 0", "Segment1_Name:=liver", "Segment1_LabelValue:=4",
                        "Segment1_Layer:=0"},
                       samples);
    }

    TemporaryFolder folder_;
};

TEST_F(NrrdSegments, have_names_colours_labels_and_layers)
{
    const auto segments = read_segments(two_layers());
    ASSERT_EQ(segments.size(), 2U);
    EXPECT_EQ(segments[0].entry.name, "left: kidney");
    EXPECT_EQ(segments[0].entry.value, 3);
    EXPECT_EQ(segments[0].layer, 1U);
    EXPECT_EQ(segments[0].entry.color, (Color{.red = 255, .green = 51, .blue = 0}));
    EXPECT_EQ(segments[1].layer, 0U);
    EXPECT_FALSE(segments[1].entry.color.has_value());
}

TEST_F(NrrdSegments, names_that_are_no_utf8_are_taken_for_latin_1)
{
    const auto segments =
        read_segments(file_of({"type: unsigned char", "dimension: 3", "sizes: 1 1 1", "encoding: raw",
                               "Segment0_Name:= C\xF4te ", "Segment1_Name:=C\xC3\xB4te"},
                              "x"));
    ASSERT_EQ(segments.size(), 2U);
    EXPECT_EQ(segments[0].entry.name, "C\xC3\xB4te");
    EXPECT_EQ(segments[1].entry.name, "C\xC3\xB4te");
}

TEST_F(NrrdSegments, layers_are_read_as_frames)
{
    const auto path = two_layers();
    for (std::size_t layer = 0; layer < 2; ++layer)
    {
        const Volume volume = read_volume(path, {.frame = layer}).volume;
        EXPECT_EQ(volume.geometry.size, (std::array<std::size_t, 3>{2, 3, 2}));
        EXPECT_EQ(volume.geometry.spacing.z, 2.0);
        EXPECT_EQ(volume.at(0, 0, 0), 100.0 * static_cast<double>(layer));
        EXPECT_EQ(volume.at(1, 2, 1), 100.0 * static_cast<double>(layer) + 11.0);
    }
    EXPECT_THROW(read_volume(path), InputError);
    EXPECT_THROW(read_volume(path, {.frame = 2}), InputError);
}

TEST_F(NrrdSegments, one_voxel_stands_for_no_data)
{
    const auto path = file_of({"type: unsigned char", "dimension: 3", "sizes: 1 1 1", "encoding: raw",
                               "Segmentation_ContainedRepresentationNames:="},
                              std::string(1, 0));
    EXPECT_TRUE(read_segments(path).empty());
    try
    {
        read_volume(path);
        FAIL();
    }
    catch (const InputError& error)
    {
        EXPECT_NE(std::string(error.what()).find("no segments"), std::string::npos) << error.what();
    }
}

TEST_F(NrrdSegments, other_files_have_none_and_broken_keys_are_refused)
{
    EXPECT_TRUE(
        read_segments(file_of({"type: unsigned char", "dimension: 3", "sizes: 2 2 2", "encoding: raw"},
                              std::string(8, 1)))
            .empty());
    EXPECT_TRUE(read_segments(folder_.path() / "absent.nrrd").empty());
    EXPECT_THROW(read_segments(file_of({"type: unsigned char", "dimension: 3", "sizes: 2 2 2",
                                        "encoding: raw", "Segment0_Name:=a", "Segment0_LabelValue:=one"},
                                       std::string(8, 1))),
                 InputError);
}

TEST_F(NrrdSegments, of_old_files_each_is_label_1_of_a_layer_of_its_own)
{
    const auto segments = read_segments(file_of({"type: unsigned char", "dimension: 3", "sizes: 2 2 2",
                                                 "encoding: raw", "Segment0_Name:=a", "Segment1_Name:=b"},
                                                std::string(8, 1)));
    ASSERT_EQ(segments.size(), 2U);
    EXPECT_EQ(segments[1].layer, 1U);
    EXPECT_EQ(segments[1].entry.value, 1);
}

} // namespace
} // namespace voroprobe
