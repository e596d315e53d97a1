//! Files that must be refused with one clear line, without a crash, without output and without a big
//! allocation.

#include <limits>

#include <gtest/gtest.h>

#include "support/memory.h"
#include "volume_expectations.h"
#include "volume_files.h"

namespace voroprobe
{

namespace
{

const std::vector<std::string> kNrrdFields{"type: short", "endian: little", "dimension: 3", "sizes: 6 5 4",
                                           "endian: little"};

std::string bytes()
{
    return to_bytes(ramp<std::int16_t>(), kLittle);
}

std::string nrrd_with(const std::string& encoding, const std::string& samples)
{
    std::vector<std::string> fields = kNrrdFields;
    fields.push_back("encoding: " + encoding);
    return nrrd_of(fields, samples);
}

std::string meta_with(const std::string& size, const std::string& more, const std::string& samples)
{
    return "ObjectType = Image\nNDims = 3\nDimSize = " + size + "\n" + more +
           "ElementType = MET_SHORT\nElementDataFile = LOCAL\n" + samples;
}

std::string inr_with(const std::string& x, const std::string& samples)
{
    return inrimage_of(
        {"XDIM=" + x, "YDIM=5", "ZDIM=4", "VDIM=1", "TYPE=signed fixed", "PIXSIZE=16 bits", "CPU=pc"},
        samples);
}

std::string vti_with(const std::string& extent)
{
    return vti_of(extent, "type=\"Int16\"", "Origin=\"0 0 0\" Spacing=\"1 1 1\"", bytes());
}

std::string tiff_with(std::size_t pages)
{
    return tiff_of({}, std::vector<std::string>(pages, std::string(60, 'x')));
}

std::string shortened(const std::string& content, std::size_t by)
{
    return content.substr(0, content.size() - by);
}

TEST(DamagedVolume, a_missing_file_is_named)
{
    expect_has(refusal_of_path("/no/such/folder/scan.nii"), "no such file");
}

TEST(DamagedVolume, a_file_of_no_known_format_is_refused)
{
    expect_has(refusal("notes.txt", "These are notes."), "no known format, expected NIfTI");
    expect_has(refusal("scan.vdb", "x"), "OpenVDB");
}

TEST(DamagedVolume, an_empty_file_is_refused)
{
    for (const char* name :
         {"v.nii", "v.nii.gz", "v.nrrd", "v.mha", "v.tif", "v.inr", "v.inr.gz", "v.vti", "v.dcm", "v"})
        expect_has(refusal(name, ""), "empty");
}

TEST(DamagedVolume, a_file_that_is_not_what_its_name_says_is_refused)
{
    const std::string junk(5000, '\x17');
    for (const char* name : {"v.nii", "v.nii.gz", "v.nrrd", "v.nhdr", "v.mha", "v.mhd", "v.tif", "v.inr",
                             "v.inr.gz", "v.vti", "v.vtk", "v.dcm"})
        expect_has(refusal(name, junk), " not ");
}

TEST(DamagedVolume, truncated_samples_are_refused)
{
    const auto packed_meta = [](const std::string& packed)
    { return meta_with("6 5 4", "BinaryDataByteOrderMSB = False\nCompressedData = True\n", packed); };
    const std::vector<std::pair<std::string, std::string>> files{
        {"v.nii", shortened(nifti_of({}, bytes()), 1)},
        {"v.nii.gz", shortened(gzip_of(nifti_of({}, bytes())), 60)},
        {"short.nii.gz", gzip_of(shortened(nifti_of({}, bytes()), 1))},
        {"header.nii", nifti_of({}, "").substr(0, 200)},
        {"v.nrrd", nrrd_with("raw", shortened(bytes(), 1))},
        {"gz.nrrd", nrrd_with("gzip", shortened(gzip_of(bytes()), 40))},
        {"short.nrrd", nrrd_with("gzip", gzip_of(shortened(bytes(), 1)))},
        {"v.mha", meta_with("6 5 4", "", shortened(bytes(), 1))},
        {"z.mha", packed_meta(shortened(zlib_of(bytes()), 30))},
        {"short.mha", packed_meta(zlib_of(shortened(bytes(), 1)))},
        {"v.inr", inr_with("6", shortened(bytes(), 1))},
        {"v.inr.gz", shortened(gzip_of(inr_with("6", bytes())), 40)},
        {"header.inr", inr_with("6", "").substr(0, 100)},
        {"v.vti", shortened(vti_with("0 5 0 4 0 3"), 100)},
        {"short.vti", vti_with("0 5 0 4 0 4")},
        {"v.tif", shortened(tiff_with(4), 30)},
        {"pages.tif", tiff_with(4).substr(0, 400)},
        {"header.tif", tiff_with(4).substr(0, 7)}};
    for (const auto& [name, content] : files)
        EXPECT_NE(refusal(name, content), "") << name;
}

TEST(DamagedVolume, damaged_compression_is_refused)
{
    std::string packed = zlib_of(bytes());
    for (std::size_t i = 10; i < 40; ++i)
        packed[i] = static_cast<char>(~packed[i]);
    EXPECT_NE(refusal("v.mha", meta_with("6 5 4", "CompressedData = True\n", packed)), "");
    std::string scan = gzip_of(nifti_of({}, bytes()));
    for (std::size_t i = scan.size() - 80; i < scan.size() - 40; ++i)
        scan[i] = static_cast<char>(~scan[i]);
    EXPECT_NE(refusal("v.nii.gz", scan), "");
}

TEST(DamagedVolume, content_that_does_not_agree_with_its_checksum_is_refused)
{
    std::string packed = zlib_of(bytes());
    packed.back() = static_cast<char>(~packed.back());
    expect_has(refusal("v.mha", meta_with("6 5 4", "CompressedData = True\n", packed)), "damaged");
    std::string scan = gzip_of(nifti_of({}, bytes()));
    char& in_checksum = scan[scan.size() - 6]; // its last four bytes are the length
    in_checksum = static_cast<char>(~in_checksum);
    expect_has(refusal("v.nii.gz", scan), "damaged");
    scan = gzip_of(nifti_of({}, bytes()));
    expect_has(refusal("v.nii.gz", shortened(scan, 1)), "damaged");
    const TemporaryFolder folder;
    scan = gzip_of(nifti_of({}, bytes()) + "what follows the samples is no damage");
    EXPECT_NO_THROW(read_volume(folder.file("v.nii.gz", scan)));
}

TEST(DamagedVolume, sizes_beyond_memory_are_refused_before_anything_is_allocated)
{
    const std::size_t before = peak_memory_bytes();
    const std::vector<std::pair<std::string, std::string>> files{
        {"v.nii", nifti_of({.size = {32000, 32000, 32000}}, bytes())},
        {"v.nrrd", nrrd_of({"type: short", "endian: little", "dimension: 3", "sizes: 30000 30000 30000",
                            "encoding: raw"},
                           bytes())},
        {"overflow.nrrd", nrrd_of({"type: short", "endian: little", "dimension: 3",
                                   "sizes: 4000000000 4000000000 4000000000", "encoding: raw"},
                                  bytes())},
        {"v.mha", meta_with("30000 30000 30000", "", bytes())},
        {"overflow.mha", meta_with("1000000000 1000000000 1000000000", "", bytes())},
        {"v.inr", inr_with("999999999999", bytes())},
        {"overflow.inr", inr_with("4611686018427387904", bytes())},
        {"v.vti", vti_with("0 2000000000 0 2000000000 0 2000000000")},
        {"v.tif", tiff_of({.width = 4000000000U, .height = 4000000000U},
                          {std::string(60, 'x'), std::string(60, 'x')})}};
    for (const auto& [name, content] : files)
        EXPECT_NE(refusal(name, content), "") << name;

    // Fits in memory, but the file is far too short for it.
    expect_has(refusal("v.nii", nifti_of({.size = {1000, 1000, 1000}}, bytes())), "truncated");
    expect_has(refusal("v.nii.gz", gzip_of(nifti_of({.size = {1000, 1000, 1000}}, bytes()))), "truncated");
    expect_has(refusal("v.mha", meta_with("1000 1000 1000", "", bytes())), "truncated");
    expect_has(refusal("z.mha", meta_with("1000 1000 1000", "CompressedData = True\n", zlib_of(bytes()))),
               "truncated");
    expect_has(refusal("v.inr", inr_with("50000000", bytes())), "truncated");
    expect_has(refusal("v.nrrd", nrrd_of({"type: short", "endian: little", "dimension: 3",
                                          "sizes: 1000 1000 1000", "encoding: raw"},
                                         bytes())),
               "truncated");
    constexpr std::size_t kAllowedGrowth = std::size_t{200} << 20U;
    EXPECT_LT(peak_memory_bytes(), before + kAllowedGrowth);
}

TEST(DamagedVolume, sizes_below_one_are_refused)
{
    for (const std::int16_t n : {std::int16_t{0}, std::int16_t{-6}})
    {
        const std::string text = std::to_string(n);
        expect_has(refusal("v.nii", nifti_of({.size = {6, n, 4}}, bytes())), "size " + text);
        expect_has(refusal("v.mha", meta_with("6 " + text + " 4", "", bytes())), text);
        expect_has(refusal("v.nrrd", nrrd_of({"type: short", "endian: little", "dimension: 3",
                                              "sizes: 6 " + text + " 4", "encoding: raw"},
                                             bytes())),
                   "size '" + text + "', expected whole numbers of at least 1");
        EXPECT_NE(refusal("v.inr", inr_with(text, bytes())), "");
    }
    EXPECT_NE(refusal("v.vti", vti_with("0 -1 0 4 0 3")), "");
}

TEST(DamagedVolume, sizes_of_a_nrrd_file_are_whole_numbers_with_a_product)
{
    const auto refusal_of_sizes = [](const std::string& sizes)
    {
        return refusal("v.nrrd", nrrd_of({"type: short", "endian: little", "dimension: 3", "sizes: " + sizes,
                                          "encoding: raw"},
                                         bytes()));
    };
    for (const char* size : {"5.5", "five", "0x5", "nan", "-9223372036854775809"})
        expect_has(refusal_of_sizes("6 " + std::string(size) + " 4"), "the header gives the size '");
    for (const char* sizes : {"4000000000 4000000000 4000000000", "6 99999999999999999999 4"})
        expect_has(refusal_of_sizes(sizes), "more samples than any memory holds");
}

TEST(DamagedVolume, a_nifti_header_that_puts_the_samples_nowhere_is_refused_in_a_short_line)
{
    std::string content = nifti_of({}, bytes());
    constexpr std::size_t kVoxOffset = 108;
    for (const float offset : {-1.0F, 1e30F, std::numeric_limits<float>::quiet_NaN()})
    {
        content.replace(kVoxOffset, sizeof(float), to_bytes(offset, std::endian::native));
        const std::string message = refusal("v.nii", content);
        expect_has(message, "puts the samples at byte ");
        expect_has(message, ", expected 352 to 1e+15");
    }
    expect_has(
        refusal("v.nii", content.replace(kVoxOffset, sizeof(float), to_bytes(1e30F, std::endian::native))),
        "at byte 1e+30,");
}

TEST(DamagedVolume, a_meta_image_is_placed_by_the_right_number_of_finite_numbers)
{
    const std::vector<std::pair<std::string, std::string>> fields{{"ElementSpacing", "nan 1 1"},
                                                                  {"ElementSpacing", "1 1 11e400"},
                                                                  {"ElementSpacing", "1 1"},
                                                                  {"ElementSize", "1 1 inf"},
                                                                  {"ElementSize", ""},
                                                                  {"Offset", "0 0 1e999"},
                                                                  {"Position", "0 0 0 0"},
                                                                  {"Origin", "0 zero 0"},
                                                                  {"TransformMatrix", "1 0 0 0 1 0 0 0"},
                                                                  {"Rotation", "11e400 0 0 0 1 0 0 0 1"},
                                                                  {"Orientation", "1 0 0 0 1 0 0 0 -nan"},
                                                                  {"ElementMin", "nan"},
                                                                  {"ElementMax", "1e999"}};
    for (const auto& [name, value] : fields)
        expect_has(refusal("v.mha", meta_with("6 5 4", name + " = " + value + "\n", bytes())), name);
}

TEST(DamagedVolume, a_single_slice_is_not_a_volume)
{
    const std::string slice(60, '\1');
    const std::vector<std::pair<std::string, std::string>> files{
        {"v.nii", nifti_of({.size = {6, 5}}, slice)},
        {"thin.nii", nifti_of({.size = {6, 5, 1}}, slice)},
        {"v.nrrd",
         nrrd_of({"type: short", "endian: little", "dimension: 2", "sizes: 6 5", "encoding: raw"}, slice)},
        {"v.mha",
         "ObjectType = Image\nNDims = 2\nDimSize = 6 5\nElementType = MET_SHORT\nElementDataFile = LOCAL\n" +
             slice},
        {"v.tif", tiff_with(1)},
        {"v.vti", vti_of("0 5 0 4 0 0", "type=\"Int16\"", "Spacing=\"1 1 1\"", slice)},
        {"v.dcm", dicom_of({}, ramp<std::int16_t>(30))}};
    for (const auto& [name, content] : files)
        expect_has(refusal(name, content), "a single slice is not a volume");
}

TEST(DamagedVolume, vector_and_color_samples_are_refused)
{
    const std::string triple = bytes() + bytes() + bytes();
    const std::vector<std::pair<std::string, std::string>> files{
        {"v.nrrd", nrrd_of({"type: short", "endian: little", "dimension: 4", "sizes: 3 6 5 4",
                            "kinds: vector domain domain domain", "encoding: raw"},
                           triple)},
        {"v.mha", meta_with("6 5 4", "ElementNumberOfChannels = 3\n", triple)},
        {"v.vti",
         vti_of("0 5 0 4 0 3", "type=\"Int16\" NumberOfComponents=\"3\"", "Spacing=\"1 1 1\"", triple)},
        {"v.tif",
         tiff_of({.bits = 8, .samples_per_pixel = 3}, {std::string(90, 'x'), std::string(90, 'x')})}};
    for (const auto& [name, content] : files)
        expect_has(refusal(name, content), "3 values in each sample (a vector or color image), expected one");
    expect_has(refusal("v.nii", nifti_of({.datatype = 128}, triple)), "color");
}

TEST(DamagedVolume, sheared_grids_are_refused)
{
    expect_has(refusal("v.nrrd", nrrd_of({"type: short", "endian: little", "dimension: 3",
                                          "space: left-posterior-superior", "sizes: 6 5 4",
                                          "space directions: (2,0,0) (1,3,0) (0,0,4)",
                                          "space origin: (0,0,0)", "encoding: raw"},
                                         bytes())),
               "orthonormal");
    expect_has(refusal("v.nii", nifti_of({.sform = {1, 0.3F, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}, bytes())),
               "sheared");
}

TEST(DamagedVolume, an_sform_skewed_by_rounding_is_accepted)
{
    const ReadVolume read =
        read_content("v.nii", nifti_of({.sform = {-1, 5e-4F, 0, 10, 0, -1, 0, 20, 0, 0, 1, 30}}, bytes()));
    EXPECT_TRUE(read.warnings.empty());
    EXPECT_NEAR(read.volume.geometry.world_from_grid.translation.x, -10.0, 1e-5);
    EXPECT_NEAR(read.volume.geometry.world_from_grid.translation.y, -20.0, 1e-5);
    EXPECT_NEAR(read.volume.geometry.world_from_grid.translation.z, 30.0, 1e-5);
}

TEST(DamagedVolume, the_qform_stands_in_for_a_sheared_sform_with_a_warning)
{
    const ReadVolume read = read_content("v.nii", nifti_of({.sform = {1, 0.3F, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0},
                                                            .quaternion = {0, 0, 0, 5, 6, 7}},
                                                           bytes()));
    ASSERT_EQ(read.warnings.size(), 1U);
    expect_has(read.warnings.front(), "sform");
    // RAS (5, 6, 7) is LPS (-5, -6, 7), the largest corner: the axes run towards right and anterior.
    const Point3 last = read.volume.geometry.world_from_grid * read.volume.geometry.grid_box().max;
    EXPECT_NEAR(distance(last, {-5, -6, 10}), 0.0, 1e-5);
}

TEST(DamagedVolume, pages_of_different_size_are_refused)
{
    std::string both = tiff_with(2);
    const std::string width_entry = to_bytes(std::uint16_t{256}, kLittle) +
                                    to_bytes(std::uint16_t{4}, kLittle) + to_bytes(std::uint32_t{1}, kLittle);
    both.replace(both.rfind(width_entry) + 8, 4, to_bytes(std::uint32_t{3}, kLittle));
    expect_has(refusal("v.tif", both),
               "page 1 is 3 x 5 uint16, expected it to be like the first, 6 x 5 uint16");
}

TEST(DamagedVolume, an_image_j_stack_has_as_many_pages_as_it_announces)
{
    const std::string description = "ImageJ=1.53\nimages=5\nslices=5\n";
    const std::string content =
        tiff_of({.description = description}, std::vector<std::string>(4, std::string(60, 'x')));
    expect_has(refusal("v.tif", content), "holds 4 pages, expected the 5");
}

TEST(DamagedVolume, a_missing_data_file_is_named)
{
    expect_has(refusal("v.mhd", "ObjectType = Image\nNDims = 3\nDimSize = 6 5 4\nElementType = MET_SHORT\n"
                                "ElementDataFile = gone.raw\n"),
               "gone.raw");
    expect_has(refusal("v.nhdr", "NRRD0004\ntype: short\nendian: little\ndimension: 3\nsizes: 6 5 "
                                 "4\nencoding: raw\ndata file: gone.raw\n"),
               "gone.raw");
}

TEST(DamagedVolume, every_shortened_header_is_refused_without_a_crash)
{
    const std::vector<std::pair<std::string, std::string>> files{
        {"v.nii", nifti_of({}, bytes())},
        {"v.nrrd", nrrd_with("raw", bytes())},
        {"v.mha", meta_with("6 5 4", "", bytes())},
        {"v.inr", inr_with("6", bytes())},
        {"v.vti", vti_with("0 5 0 4 0 3")},
        {"v.tif", tiff_with(3)},
        {"v.dcm", dicom_of({}, ramp<std::int16_t>(30))}};
    for (const auto& [name, content] : files)
        for (std::size_t length = 1; length + 20 < content.size(); length += 23)
            EXPECT_NE(refusal(name, content.substr(0, length)), "") << name << " cut at " << length;
}

} // namespace

} // namespace voroprobe
