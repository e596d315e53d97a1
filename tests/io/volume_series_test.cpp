//! Folders: TIFF sequences in natural order, DICOM series in order of position.

#include <gtest/gtest.h>

#include "volume_expectations.h"
#include "volume_files.h"

namespace voroprobe
{

namespace
{

//! A TIFF of one page whose samples all have the value `slice`.
std::string tiff_slice(std::uint8_t slice)
{
    return tiff_of({.bits = 8}, {std::string(30, static_cast<char>(slice))});
}

std::vector<std::int16_t> dicom_samples(int slice)
{
    std::vector<std::int16_t> samples = ramp<std::int16_t>(30);
    for (std::int16_t& sample : samples)
        sample = static_cast<std::int16_t>(sample + 100 * slice);
    return samples;
}

//! A slice at height `z` whose samples tell its number.
std::string dicom_slice(int number, double z, const std::string& series = "1.2.3.4")
{
    return dicom_of(
        {.series = series, .instance = number + 1, .position = {-3, 4, z}, .pixel_spacing = {0.5, 0.25}},
        dicom_samples(number));
}

//! Writes slices 2.5 mm apart under names in an unrelated order; returns nothing, the folder has them.
void write_series(const TemporaryFolder& folder, const std::vector<double>& heights)
{
    for (std::size_t i = 0; i < heights.size(); ++i)
        static_cast<void>(folder.file(std::to_string((i * 7 + 3) % 10) + ".dcm",
                                      dicom_slice(static_cast<int>(i), heights[i])));
}

TEST(TiffSequence, slice_2_comes_before_slice_10)
{
    const TemporaryFolder folder;
    for (const std::uint8_t number : {9, 10, 8, 11, 12})
        static_cast<void>(folder.file("scan_" + std::to_string(number) + ".tif", tiff_slice(number)));
    static_cast<void>(folder.file("readme.txt", "not a slice"));
    const ReadVolume read = read_volume(folder.path());
    EXPECT_EQ(read.format, "TIFF");
    EXPECT_FALSE(read.has_spacing);
    ASSERT_EQ(read.volume.geometry.size, (std::array<std::size_t, 3>{6, 5, 5}));
    for (std::size_t k = 0; k < 5; ++k)
        EXPECT_EQ(read.volume.at(0, 0, k), 8.0 + static_cast<double>(k));
}

TEST(TiffSequence, a_missing_slice_is_named)
{
    const TemporaryFolder folder;
    for (const std::uint8_t number : {1, 2, 4, 5})
        static_cast<void>(folder.file("scan_" + std::to_string(number) + ".tif", tiff_slice(number)));
    expect_has(refusal_of_path(folder.path()), "missing between scan_2.tif and scan_4.tif");
}

TEST(TiffSequence, an_unreadable_slice_is_named)
{
    const TemporaryFolder folder;
    for (const std::uint8_t number : {1, 2, 3})
        static_cast<void>(folder.file("scan_" + std::to_string(number) + ".tif", tiff_slice(number)));
    static_cast<void>(folder.file("scan_2.tif", "II*"));
    expect_has(refusal_of_path(folder.path()), "slice scan_2.tif");
    static_cast<void>(folder.file("scan_2.tif", tiff_of({.bits = 8, .width = 5}, {std::string(25, 'x')})));
    expect_has(refusal_of_path(folder.path()),
               "slice scan_2.tif is 5 x 5 uint8, expected it to be like the first, 6 x 5");
    static_cast<void>(
        folder.file("scan_2.tif", tiff_of({.bits = 8}, {std::string(30, 'x'), std::string(30, 'x')})));
    expect_has(refusal_of_path(folder.path()), "slice scan_2.tif holds several pages");
}

TEST(TiffSequence, one_slice_is_not_a_volume)
{
    const TemporaryFolder folder;
    static_cast<void>(folder.file("scan_1.tif", tiff_slice(1)));
    expect_has(refusal_of_path(folder.path()), "a single slice is not a volume");
}

TEST(Folder, without_slices_it_is_refused)
{
    const TemporaryFolder folder;
    expect_has(refusal_of_path(folder.path()), "empty");
    static_cast<void>(folder.file("readme.txt", "nothing to see"));
    expect_has(refusal_of_path(folder.path()), "neither DICOM nor TIFF");
}

TEST(DicomSeries, slices_are_ordered_by_position_whatever_their_names)
{
    const TemporaryFolder folder;
    write_series(folder, {20.0, 12.5, 17.5, 10.0, 15.0});
    const ReadVolume read = read_volume(folder.path());
    EXPECT_EQ(read.format, "DICOM");
    EXPECT_EQ(read.stored_type, "int16");
    EXPECT_TRUE(read.warnings.empty());
    ASSERT_EQ(read.volume.geometry.size, (std::array<std::size_t, 3>{6, 5, 5}));
    EXPECT_NEAR(distance(read.volume.geometry.spacing, {0.25, 0.5, 2.5}), 0.0, 1e-12);
    EXPECT_NEAR(distance(read.volume.geometry.world_from_grid.translation, {-3, 4, 10}), 0.0, 1e-12);
    const std::array<double, 5> numbers{3, 1, 4, 2, 0};
    for (std::size_t k = 0; k < 5; ++k)
        EXPECT_EQ(read.volume.at(5, 4, k), 29 + 100 * numbers[k]);
}

TEST(DicomSeries, slope_and_intercept_are_applied)
{
    const TemporaryFolder folder;
    for (int i = 0; i < 3; ++i)
        static_cast<void>(folder.file(
            "s" + std::to_string(i),
            dicom_of(
                {.instance = i, .position = {0, 0, 1.0 * i}, .slope = i == 1 ? 0.5 : 2.0, .intercept = -1024},
                dicom_samples(i))));
    const Volume volume = read_volume(folder.path()).volume;
    EXPECT_EQ(volume.at(5, 4, 0), 2.0 * 29 - 1024);
    EXPECT_EQ(volume.at(5, 4, 1), 0.5 * 129 - 1024);
    EXPECT_EQ(volume.at(5, 4, 2), 2.0 * 229 - 1024);
}

TEST(DicomSeries, an_oblique_series_stands_where_its_positions_say)
{
    // Rows run along y, columns along -z, so slices follow each other along -x.
    const TemporaryFolder folder;
    for (int i = 0; i < 4; ++i)
        static_cast<void>(folder.file(
            std::to_string(i) + ".dcm",
            dicom_of({.instance = i, .position = {50.0 - 2.0 * i, -8, 9}, .orientation = {0, 1, 0, 0, 0, -1}},
                     dicom_samples(i))));
    const Volume volume = read_volume(folder.path()).volume;
    const GridGeometry& geometry = volume.geometry;
    ASSERT_EQ(geometry.size, (std::array<std::size_t, 3>{4, 6, 5}));
    EXPECT_NEAR(distance(geometry.world_from_grid * Point3{0, 0, 0}, {44, -8, 5}), 0.0, 1e-9);
    EXPECT_EQ(volume.at(0, 0, 0), 300 + 4 * 6) << "last slice, last row, first column";
    EXPECT_EQ(volume.at(3, 5, 4), 0 + 5) << "first slice, first row, last column";
}

TEST(DicomSeries, a_missing_slice_is_named)
{
    const TemporaryFolder folder;
    write_series(folder, {0, 2.5, 5, 10, 12.5});
    const std::string message = refusal_of_path(folder.path());
    expect_has(message, "a slice is missing");
    expect_has(message, "5.000000 mm apart, expected 2.500000");
}

TEST(DicomSeries, unequal_spacing_is_a_warning_while_it_is_slight)
{
    const TemporaryFolder slight;
    write_series(slight, {0, 2.5, 5.1, 7.5});
    const ReadVolume read = read_volume(slight.path());
    ASSERT_EQ(read.warnings.size(), 1U);
    expect_has(read.warnings.front(), "unequal spacing");
    const TemporaryFolder serious;
    write_series(serious, {0, 2.5, 5.5, 7.5});
    expect_has(refusal_of_path(serious.path()), "unequal spacing");
}

TEST(DicomSeries, two_slices_at_one_place_are_refused)
{
    const TemporaryFolder folder;
    write_series(folder, {0, 2.5, 2.5, 5});
    expect_has(refusal_of_path(folder.path()), "same position");
}

TEST(DicomSeries, a_tilted_gantry_is_refused)
{
    const TemporaryFolder folder;
    for (int i = 0; i < 4; ++i)
        static_cast<void>(
            folder.file(std::to_string(i) + ".dcm",
                        dicom_of({.instance = i, .position = {0, 1.0 * i, 2.0 * i}}, dicom_samples(i))));
    expect_has(refusal_of_path(folder.path()), "shifted sideways");
}

// PS3.5 section 6.2.2: what is in it is encoded without types, whatever the rest of the file has.
TEST(DicomSeries, a_sequence_of_unknown_type_and_undefined_length_is_passed_over)
{
    const std::string undefined(4, '\xff');
    const std::string empty(4, '\0');
    const std::string element_of_item = std::string("\x29\0\x01\x11\4\0\0\0", 8) + "abcd";
    const std::string private_sequence = std::string("\x29\0\x01\x10UN\0\0", 8) + undefined + //
                                         std::string("\xfe\xff\0\xe0", 4) + undefined +
                                         element_of_item +                            // item
                                         std::string("\xfe\xff\x0d\xe0", 4) + empty + // end of item
                                         std::string("\xfe\xff\xdd\xe0", 4) + empty;  // end of sequence
    const TemporaryFolder folder;
    for (int i = 0; i < 3; ++i)
        static_cast<void>(
            folder.file(std::to_string(i) + ".dcm",
                        dicom_of({.instance = i, .position = {0, 0, 2.0 * i}, .further = private_sequence},
                                 dicom_samples(i))));
    const ReadVolume read = read_volume(folder.path());
    ASSERT_EQ(read.volume.geometry.size, (std::array<std::size_t, 3>{6, 5, 3}));
    EXPECT_EQ(read.volume.at(0, 0, 2) - read.volume.at(0, 0, 1), 100.0);
}

TEST(DicomSeries, an_unreadable_slice_is_named)
{
    const std::string whole = dicom_slice(1, 2.5);
    for (const std::string& spoiled :
         {whole.substr(0, whole.size() - 20), whole.substr(0, 150), std::string(500, 'x')})
    {
        const TemporaryFolder folder;
        static_cast<void>(folder.file("a.dcm", dicom_slice(0, 0)));
        static_cast<void>(folder.file("b.dcm", spoiled));
        static_cast<void>(folder.file("c.dcm", dicom_slice(2, 5)));
        expect_has(refusal_of_path(folder.path()), "slice b.dcm");
    }
}

TEST(DicomSeries, a_slice_of_another_size_or_orientation_is_named)
{
    const TemporaryFolder folder;
    write_series(folder, {0, 2.5, 5});
    static_cast<void>(folder.file("turned.dcm", dicom_of({.instance = 9,
                                                          .position = {-3, 4, 7.5},
                                                          .orientation = {0, 1, 0, -1, 0, 0},
                                                          .pixel_spacing = {0.5, 0.25}},
                                                         dicom_samples(3))));
    expect_has(refusal_of_path(folder.path()), "orientation");
}

TEST(DicomSeries, several_series_are_listed_until_one_is_chosen)
{
    const TemporaryFolder folder;
    for (int i = 0; i < 3; ++i)
    {
        static_cast<void>(folder.file("a" + std::to_string(i), dicom_slice(i, 2.0 * i, "1.2.3.111")));
        static_cast<void>(folder.file("b" + std::to_string(i), dicom_slice(i + 3, 3.0 * i, "1.2.3.222")));
    }
    const std::string message = refusal_of_path(folder.path());
    expect_has(message, "2 series");
    expect_has(message, "--series");
    expect_has(message, "1.2.3.111");
    expect_has(message, "1.2.3.222");
    EXPECT_NEAR(read_volume(folder.path(), {.series = "222"}).volume.geometry.spacing.z, 3.0, 1e-12);
    EXPECT_NEAR(read_volume(folder.path(), {.series = "1.2.3.111"}).volume.geometry.spacing.z, 2.0, 1e-12);
    expect_has(refusal_of_path(folder.path(), {.series = "999"}), "no series with \"999\"");
    expect_has(refusal_of_path(folder.path(), {.series = "1.2.3"}), "2 series");
}

} // namespace

} // namespace voroprobe
