#include <cmath>
#include <fstream>

#include <limits>

#include <gtest/gtest.h>

#include "volume_expectations.h"
#include "volume_files.h"

namespace voroprobe
{

namespace
{

//! One type as each format names it.
template <class Sample>
struct Names;
template <>
struct Names<std::uint8_t>
{
    static constexpr std::int16_t kNifti = 2;
    static constexpr const char* kNrrd = "uint8";
    static constexpr const char* kMeta = "MET_UCHAR";
    static constexpr const char* kInr = "unsigned fixed";
    static constexpr const char* kVtk = "UInt8";
    static constexpr std::uint16_t kTiff = 1;
};
template <>
struct Names<std::int8_t>
{
    static constexpr std::int16_t kNifti = 256;
    static constexpr const char* kNrrd = "int8";
    static constexpr const char* kMeta = "MET_CHAR";
    static constexpr const char* kInr = "signed fixed";
    static constexpr const char* kVtk = "Int8";
    static constexpr std::uint16_t kTiff = 2;
};
template <>
struct Names<std::uint16_t>
{
    static constexpr std::int16_t kNifti = 512;
    static constexpr const char* kNrrd = "uint16";
    static constexpr const char* kMeta = "MET_USHORT";
    static constexpr const char* kInr = "unsigned fixed";
    static constexpr const char* kVtk = "UInt16";
    static constexpr std::uint16_t kTiff = 1;
};
template <>
struct Names<std::int16_t>
{
    static constexpr std::int16_t kNifti = 4;
    static constexpr const char* kNrrd = "int16";
    static constexpr const char* kMeta = "MET_SHORT";
    static constexpr const char* kInr = "signed fixed";
    static constexpr const char* kVtk = "Int16";
    static constexpr std::uint16_t kTiff = 2;
};
template <>
struct Names<std::uint32_t>
{
    static constexpr std::int16_t kNifti = 768;
    static constexpr const char* kNrrd = "uint32";
    static constexpr const char* kMeta = "MET_UINT";
    static constexpr const char* kInr = "unsigned fixed";
    static constexpr const char* kVtk = "UInt32";
    static constexpr std::uint16_t kTiff = 1;
};
template <>
struct Names<std::int32_t>
{
    static constexpr std::int16_t kNifti = 8;
    static constexpr const char* kNrrd = "int32";
    static constexpr const char* kMeta = "MET_INT";
    static constexpr const char* kInr = "signed fixed";
    static constexpr const char* kVtk = "Int32";
    static constexpr std::uint16_t kTiff = 2;
};
template <>
struct Names<std::uint64_t>
{
    static constexpr std::int16_t kNifti = 1280;
    static constexpr const char* kNrrd = "uint64";
    static constexpr const char* kMeta = "MET_ULONG_LONG";
    static constexpr const char* kInr = "unsigned fixed";
    static constexpr const char* kVtk = "UInt64";
    static constexpr std::uint16_t kTiff = 1;
};
template <>
struct Names<std::int64_t>
{
    static constexpr std::int16_t kNifti = 1024;
    static constexpr const char* kNrrd = "int64";
    static constexpr const char* kMeta = "MET_LONG_LONG";
    static constexpr const char* kInr = "signed fixed";
    static constexpr const char* kVtk = "Int64";
    static constexpr std::uint16_t kTiff = 2;
};
template <>
struct Names<float>
{
    static constexpr std::int16_t kNifti = 16;
    static constexpr const char* kNrrd = "float";
    static constexpr const char* kMeta = "MET_FLOAT";
    static constexpr const char* kInr = "float";
    static constexpr const char* kVtk = "Float32";
    static constexpr std::uint16_t kTiff = 3;
};
template <>
struct Names<double>
{
    static constexpr std::int16_t kNifti = 64;
    static constexpr const char* kNrrd = "double";
    static constexpr const char* kMeta = "MET_DOUBLE";
    static constexpr const char* kInr = "float";
    static constexpr const char* kVtk = "Float64";
    static constexpr std::uint16_t kTiff = 3;
};

//! A ramp with the smallest and the largest value that the type and 53 bits can hold.
template <class Sample>
std::vector<Sample> samples_of_type()
{
    std::vector<Sample> samples = ramp<Sample>();
    if constexpr (sizeof(Sample) < 8)
    {
        samples.front() = std::numeric_limits<Sample>::lowest();
        samples.back() = std::numeric_limits<Sample>::max();
    }
    return samples;
}

std::string meta_of(const std::vector<std::string>& fields, const std::string& samples)
{
    std::vector<std::string> all{"ObjectType = Image", "NDims = 3", "DimSize = 6 5 4",
                                 "ElementSpacing = 1 2 3"};
    all.insert(all.end(), fields.begin(), fields.end());
    all.emplace_back("ElementDataFile = LOCAL");
    return lines(all) + samples;
}

std::string inr_of(const std::string& type, std::size_t sample_bytes, const std::string& cpu,
                   const std::string& samples)
{
    return inrimage_of({"XDIM=6", "YDIM=5", "ZDIM=4", "VDIM=1", "TYPE=" + type,
                        "PIXSIZE=" + std::to_string(8 * sample_bytes) + " bits", "SCALE=2**0", "CPU=" + cpu,
                        "VX=1", "VY=2", "VZ=3", "TX=-7", "TY=8", "TZ=0.5"},
                       samples);
}

template <class Sample>
void expect_values(const ReadVolume& read, const std::vector<Sample>& samples, const char* format)
{
    EXPECT_EQ(read.format, format);
    EXPECT_EQ(read.volume.geometry.size, (std::array<std::size_t, 3>{6, 5, 4}));
    EXPECT_EQ(values_of(read.volume), std::vector<double>(samples.begin(), samples.end())) << format;
}

template <class Sample>
class EveryType : public testing::Test
{
};
using Types = testing::Types<std::uint8_t, std::int8_t, std::uint16_t, std::int16_t, std::uint32_t,
                             std::int32_t, std::uint64_t, std::int64_t, float, double>;
TYPED_TEST_SUITE(EveryType, Types);

TYPED_TEST(EveryType, is_read_from_every_format_in_both_byte_orders)
{
    using N = Names<TypeParam>;
    const std::vector<TypeParam> samples = samples_of_type<TypeParam>();
    const std::string bits = std::to_string(8 * sizeof(TypeParam));
    for (const std::endian order : {kLittle, kBig})
    {
        const bool big = order == kBig;
        const std::string bytes = to_bytes(samples, order);
        expect_values(read_content("v.nii", nifti_of({.datatype = N::kNifti, .order = order}, bytes)),
                      samples, "NIfTI");
        expect_values(
            read_content("v.nrrd", nrrd_of({std::string("type: ") + N::kNrrd, "dimension: 3", "sizes: 6 5 4",
                                            "encoding: raw", big ? "endian: big" : "endian: little"},
                                           bytes)),
            samples, "NRRD");
        expect_values(read_content("v.mha", meta_of({"BinaryData = True",
                                                     big ? "BinaryDataByteOrderMSB = True"
                                                         : "BinaryDataByteOrderMSB = False",
                                                     std::string("ElementType = ") + N::kMeta},
                                                    bytes)),
                      samples, "MetaImage");
        expect_values(read_content("v.inr", inr_of(N::kInr, sizeof(TypeParam), big ? "sun" : "decm", bytes)),
                      samples, "Inrimage");
        const TiffPages layout{.bits = 8 * sizeof(TypeParam), .format = N::kTiff, .order = order};
        std::vector<std::string> pages;
        for (std::size_t page = 0; page < 4; ++page)
            pages.push_back(bytes.substr(page * bytes.size() / 4, bytes.size() / 4));
        expect_values(read_content("v.tif", tiff_of(layout, pages)), samples, "TIFF");
    }
    expect_values(
        read_content("v.vti", vti_of("0 5 0 4 0 3", std::string("type=\"") + N::kVtk + "\"",
                                     "Origin=\"0 0 0\" Spacing=\"1 1 1\"", to_bytes(samples, kLittle))),
        samples, "VTK image data");
}

TEST(VolumeFormats, wide_integers_become_int32_where_they_fit)
{
    std::vector<std::int64_t> samples = ramp<std::int64_t>();
    const auto read = [&]
    { return read_content("v.nii", nifti_of({.datatype = 1024}, to_bytes(samples, std::endian::native))); };
    EXPECT_EQ(sample_type_name(read().volume.samples), "int32");
    EXPECT_EQ(read().stored_type, "int64");
    samples[3] = std::int64_t{1} << 40;
    EXPECT_EQ(sample_type_name(read().volume.samples), "float64");
    EXPECT_EQ(read().volume.at(3, 0, 0), std::ldexp(1.0, 40));
}

TEST(VolumeFormats, nifti_slope_and_intercept_are_applied)
{
    const std::string bytes = to_bytes(ramp<std::int16_t>(), std::endian::native);
    const ReadVolume fractional = read_content("v.nii", nifti_of({.slope = 0.5F, .intercept = -7.0F}, bytes));
    EXPECT_EQ(fractional.volume.at(5, 4, 3), 0.5 * 119 - 7.0);
    EXPECT_EQ(fractional.stored_type, "int16");
    EXPECT_EQ(sample_type_name(fractional.volume.samples), "float32");

    const ReadVolume whole = read_content("v.nii", nifti_of({.slope = 1.0F, .intercept = -1024.0F}, bytes));
    EXPECT_EQ(whole.volume.at(5, 4, 3), 119.0 - 1024.0);
    EXPECT_EQ(sample_type_name(whole.volume.samples), "int16");

    const ReadVolume unscaled = read_content("v.nii", nifti_of({.slope = 0.0F, .intercept = 5.0F}, bytes));
    EXPECT_EQ(unscaled.volume.at(5, 4, 3), 119.0) << "a slope of 0 means that values are not scaled";
}

TEST(VolumeFormats, meta_image_intensity_function_is_applied)
{
    const ReadVolume read =
        read_content("v.mha", meta_of({"ElementToIntensityFunctionSlope = 2",
                                       "ElementToIntensityFunctionOffset = -3", "ElementType = MET_UCHAR"},
                                      to_bytes(ramp<std::uint8_t>(), kLittle)));
    EXPECT_EQ(read.volume.at(5, 4, 3), 2.0 * 119 - 3.0);
}

TEST(VolumeFormats, inrimage_fixed_point_scale_and_translation_are_applied)
{
    std::string content = inr_of("unsigned fixed", 1, "pc", to_bytes(ramp<std::uint8_t>(), kLittle));
    content.replace(content.find("SCALE=2**0\n"), 12, "SCALE=2**-2\n");
    content = content.substr(0, 252) + "##}\n" + content.substr(content.size() - 120);
    const ReadVolume read = read_content("v.inr.gz", gzip_of(content));
    EXPECT_EQ(read.volume.at(5, 4, 3), 119.0 / 4.0);
    EXPECT_EQ(read.volume.geometry.spacing, (Vec3{1, 2, 3}));
    EXPECT_EQ(read.volume.geometry.world_from_grid.translation, (Point3{-7, 8, 0.5}));
}

TEST(VolumeFormats, compressed_samples_are_unpacked)
{
    const std::vector<std::int16_t> samples = ramp<std::int16_t>();
    const std::string bytes = to_bytes(samples, kLittle);
    expect_values(read_content("v.nii.gz", gzip_of(nifti_of({.order = kLittle}, bytes))), samples, "NIfTI");
    expect_values(read_content("v.nrrd", nrrd_of({"type: short", "dimension: 3", "sizes: 6 5 4",
                                                  "encoding: gzip", "endian: little"},
                                                 gzip_of(bytes))),
                  samples, "NRRD");
    for (const std::string& packed : {zlib_of(bytes), gzip_of(bytes)})
        expect_values(
            read_content("v.mha", meta_of({"CompressedData = True", "BinaryDataByteOrderMSB = False",
                                           "ElementType = MET_SHORT"},
                                          packed)),
            samples, "MetaImage");
}

TEST(VolumeFormats, samples_are_found_in_files_beside_the_header)
{
    const std::vector<std::uint8_t> samples = ramp<std::uint8_t>();
    const std::string bytes = to_bytes(samples, kLittle);
    const TemporaryFolder folder;
    static_cast<void>(folder.file("v.raw", bytes));
    static_cast<void>(folder.file("headed.raw", "16 bytes before." + bytes));
    static_cast<void>(folder.file("v.zraw", zlib_of(bytes)));
    for (std::size_t slice = 0; slice < 4; ++slice)
        static_cast<void>(
            folder.file("slice" + std::to_string(slice + 8) + ".raw", bytes.substr(slice * 30, 30)));
    static_cast<void>(folder.file("slice08.raw", "not this one"));

    const auto read = [&](const std::string& name, const std::string& header)
    { return read_volume(folder.file(name, header)); };
    const auto meta = [&](const std::vector<std::string>& fields)
    { return "ObjectType = Image\nNDims = 3\nDimSize = 6 5 4\nElementType = MET_UCHAR\n" + lines(fields); };
    expect_values(read("a.mhd", meta({"ElementDataFile = v.raw"})), samples, "MetaImage");
    expect_values(read("b.mhd", meta({"HeaderSize = 16", "ElementDataFile = headed.raw"})), samples,
                  "MetaImage");
    expect_values(read("c.mhd", meta({"HeaderSize = -1", "ElementDataFile = headed.raw"})), samples,
                  "MetaImage");
    expect_values(read("d.mhd", meta({"CompressedData = True", "ElementDataFile = v.zraw"})), samples,
                  "MetaImage");
    expect_values(read("e.mhd", meta({"ElementDataFile = slice%d.raw 8 11 1"})), samples, "MetaImage");
    expect_values(read("f.mhd", meta({"ElementDataFile = LIST", "slice8.raw", "slice9.raw", "slice10.raw",
                                      "slice11.raw"})),
                  samples, "MetaImage");
    expect_values(
        read("v.nhdr",
             "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 6 5 4\nencoding: raw\ndata file: v.raw\n"),
        samples, "NRRD");
}

TEST(VolumeFormats, samples_that_are_not_finite_are_kept)
{
    std::vector<float> samples = ramp<float>();
    samples[0] = std::nanf("");
    samples[1] = INFINITY;
    const std::string bytes = to_bytes(samples, kLittle);
    const std::vector<ReadVolume> all{
        read_content("v.nii", nifti_of({.datatype = 16, .order = kLittle}, bytes)),
        read_content("v.nrrd", nrrd_of({"type: float", "dimension: 3", "sizes: 6 5 4", "encoding: raw",
                                        "endian: little"},
                                       bytes)),
        read_content("v.mha", meta_of({"BinaryDataByteOrderMSB = False", "ElementType = MET_FLOAT"}, bytes))};
    for (const ReadVolume& read : all)
    {
        EXPECT_TRUE(std::isnan(read.volume.at(0, 0, 0))) << read.format;
        EXPECT_TRUE(std::isinf(read.volume.at(1, 0, 0))) << read.format;
    }
}

TEST(VolumeFormats, a_frame_is_chosen_from_a_file_of_several)
{
    const std::string bytes = to_bytes(ramp<std::uint8_t>(240), kLittle);
    const std::string image_j = "ImageJ=1.53\nimages=8\nslices=4\nframes=2\n";
    const std::string image_j_channels = "ImageJ=1.53\nimages=8\nchannels=2\nslices=4\n";
    std::vector<std::string> pages;
    std::vector<std::string> interleaved;
    for (std::size_t page = 0; page < 8; ++page)
    {
        pages.push_back(bytes.substr(30 * page, 30));
        interleaved.push_back(bytes.substr(30 * (page / 2 + 4 * (page % 2)), 30));
    }
    const std::vector<std::pair<std::string, std::string>> files{
        {"v.nii", nifti_of({.size = {6, 5, 4, 2}, .datatype = 2}, bytes)},
        {"v.nii.gz", gzip_of(nifti_of({.size = {6, 5, 4, 2}, .datatype = 2}, bytes))},
        {"v.nrrd", nrrd_of({"type: uchar", "dimension: 4", "sizes: 6 5 4 2", "encoding: raw"}, bytes)},
        {"v.mha", "ObjectType = Image\nNDims = 4\nDimSize = 6 5 4 2\nElementType = "
                  "MET_UCHAR\nElementDataFile = LOCAL\n" +
                      bytes},
        {"z.mha",
         "ObjectType = Image\nNDims = 4\nDimSize = 6 5 4 2\nCompressedData = True\nElementType = MET_UCHAR\n"
         "ElementDataFile = LOCAL\n" +
             zlib_of(bytes)},
        {"v.tif", tiff_of({.bits = 8, .description = image_j}, pages)},
        {"c.tif", tiff_of({.bits = 8, .description = image_j_channels}, interleaved)}};
    for (const auto& [name, content] : files)
    {
        expect_has(refusal(name, content), "2 volumes, expected one: choose with --frame 0 to 1");
        expect_has(refusal(name, content, {.frame = 2}), "no frame 2, expected 0 to 1");
        EXPECT_EQ(read_content(name, content, {.frame = 0}).volume.at(5, 4, 3), 119.0) << name;
        EXPECT_EQ(read_content(name, content, {.frame = 1}).volume.at(0, 0, 0), 120.0) << name;
        EXPECT_EQ(read_content(name, content, {.frame = 1}).volume.at(5, 4, 3), 239.0) << name;
    }
}

TEST(VolumeFormats, one_frame_in_four_dimensions_is_a_volume)
{
    const std::string bytes = to_bytes(ramp<std::uint8_t>(), kLittle);
    EXPECT_EQ(
        read_content("v.nii", nifti_of({.size = {6, 5, 4, 1}, .datatype = 2}, bytes)).volume.at(5, 4, 3),
        119.0);
    EXPECT_EQ(read_content("v.nrrd",
                           nrrd_of({"type: uchar", "dimension: 4", "sizes: 6 5 4 1", "encoding: raw"}, bytes))
                  .volume.at(5, 4, 3),
              119.0);
}

TEST(VolumeFormats, a_missing_spacing_is_told_and_can_be_given)
{
    const std::string bytes = to_bytes(ramp<std::uint8_t>(), kLittle);
    std::vector<std::string> pages;
    for (std::size_t page = 0; page < 4; ++page)
        pages.push_back(bytes.substr(30 * page, 30));
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::pair<std::string, std::string>> files{
        {"v.tif", tiff_of({.bits = 8}, pages)},
        {"v.nii", nifti_of({.datatype = 2, .spacing = {0, 0, 0}}, bytes)},
        {"zero.nii", nifti_of({.datatype = 2, .spacing = {2, 0, 3}}, bytes)},
        {"nan.nii", nifti_of({.datatype = 2, .spacing = {2, 3, kNan}}, bytes)},
        {"nan.nrrd",
         nrrd_of({"type: uchar", "dimension: 3", "sizes: 6 5 4", "spacings: 2 nan 3", "encoding: raw"},
                 bytes)},
        {"v.nrrd", nrrd_of({"type: uchar", "dimension: 3", "sizes: 6 5 4", "encoding: raw"}, bytes)},
        {"v.mha", "ObjectType = Image\nNDims = 3\nDimSize = 6 5 4\nElementType = MET_UCHAR\nElementDataFile "
                  "= LOCAL\n" +
                      bytes},
        {"v.inr", inrimage_of({"XDIM=6", "YDIM=5", "ZDIM=4", "VDIM=1", "TYPE=unsigned fixed",
                               "PIXSIZE=8 bits", "CPU=pc"},
                              bytes)}};
    for (const auto& [name, content] : files)
    {
        const ReadVolume assumed = read_content(name, content);
        EXPECT_FALSE(assumed.has_spacing) << name;
        ASSERT_EQ(assumed.warnings.size(), 1U) << name;
        expect_has(assumed.warnings.front(), "--spacing");
        EXPECT_EQ(assumed.volume.geometry.spacing, (Vec3{1, 1, 1})) << name;

        const ReadVolume given = read_content(name, content, {.spacing = Vec3{0.5, 0.5, 2}});
        EXPECT_TRUE(given.has_spacing) << name;
        EXPECT_TRUE(given.warnings.empty()) << name;
        EXPECT_EQ(given.volume.geometry.spacing, (Vec3{0.5, 0.5, 2})) << name;
    }
    EXPECT_THROW(read_content("v.tif", files.front().second, {.spacing = Vec3{1, 0, 1}}), UsageError);
}

TEST(VolumeFormats, a_nifti_scaling_that_is_no_number_is_ignored_with_a_warning)
{
    const std::string samples = to_bytes(ramp<std::int16_t>(), std::endian::native);
    for (const float slope :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
    {
        const ReadVolume read = read_content("v.nii", nifti_of({.slope = slope, .intercept = 3}, samples));
        ASSERT_EQ(read.warnings.size(), 1U);
        expect_has(read.warnings.front(), "taken as stored");
        EXPECT_EQ(read.volume.at(1, 0, 0), read_content("w.nii", nifti_of({}, samples)).volume.at(1, 0, 0));
    }
}

TEST(VolumeFormats, a_nrrd_file_in_another_unit_than_mm_is_warned_of)
{
    const auto with_units = [](const std::string& units)
    {
        return nrrd_of({"type: uchar", "dimension: 3", "space: left-posterior-superior", "sizes: 6 5 4",
                        "space directions: (2,0,0) (0,3,0) (0,0,4)", "space units: " + units,
                        "space origin: (0,0,0)", "encoding: raw"},
                       std::string(120, 'x'));
    };
    const std::string microns = with_units("\"um\" \"um\" \"um\"");
    const ReadVolume read = read_content("v.nrrd", microns);
    ASSERT_EQ(read.warnings.size(), 1U);
    expect_has(read.warnings.front(), "'um'");
    EXPECT_TRUE(read_content("v.nrrd", microns, {.spacing = Vec3{1, 1, 1}}).warnings.empty());
    EXPECT_TRUE(read_content("v.nrrd", with_units("\"mm\" \"mm\" \"mm\"")).warnings.empty());
}

TEST(VolumeFormats, the_units_of_the_axes_of_a_nrrd_file_outside_a_space_are_heeded_too)
{
    const auto warnings = [](const std::string& units)
    {
        return read_content("v.nrrd", nrrd_of({"type: uchar", "dimension: 4", "sizes: 6 5 4 1",
                                               "spacings: 2 3 4 1", "units: " + units, "encoding: raw"},
                                              std::string(120, 'x')))
            .warnings;
    };
    ASSERT_EQ(warnings("\"mm\" \"mm\" \"inch\" \"s\"").size(), 1U);
    expect_has(warnings("\"mm\" \"mm\" \"inch\" \"s\"").front(), "the unit 'inch'");
    EXPECT_TRUE(warnings("\"mm\" \"mm\" \"mm\" \"s\"").empty());
}

TEST(VolumeFormats, whole_numbers_that_a_double_cannot_hold_are_counted)
{
    const auto warnings = [](const auto& samples, std::int16_t datatype)
    {
        return read_content("v.nii", nifti_of({.datatype = datatype}, to_bytes(samples, std::endian::native)))
            .warnings;
    };
    constexpr std::int64_t kLast = std::int64_t{1} << 53; // from here on only every other number
    std::vector<std::int64_t> signed_samples = ramp<std::int64_t>();
    signed_samples[0] = kLast;
    signed_samples[1] = -kLast;
    signed_samples[2] = std::int64_t{1} << 60;
    signed_samples[3] = std::numeric_limits<std::int64_t>::min();
    EXPECT_TRUE(warnings(signed_samples, 1024).empty());
    signed_samples[0] = kLast + 1;
    signed_samples[1] = -kLast - 1;
    ASSERT_EQ(warnings(signed_samples, 1024).size(), 1U);
    expect_has(warnings(signed_samples, 1024).front(), "beyond 2^53 and lose their last digits: 2 ");

    std::vector<std::uint64_t> unsigned_samples = ramp<std::uint64_t>();
    unsigned_samples[7] = std::numeric_limits<std::uint64_t>::max();
    ASSERT_EQ(warnings(unsigned_samples, 1280).size(), 1U);
    expect_has(warnings(unsigned_samples, 1280).front(), ": 1 ");
}

TEST(VolumeFormats, given_spacing_overrides_that_of_the_file)
{
    const std::string content =
        nifti_of({.datatype = 2, .spacing = {3, 3, 3}}, to_bytes(ramp<std::uint8_t>(), kLittle));
    EXPECT_EQ(read_content("v.nii", content).volume.geometry.spacing, (Vec3{3, 3, 3}));
    EXPECT_EQ(read_content("v.nii", content, {.spacing = Vec3{1, 2, 4}}).volume.geometry.spacing,
              (Vec3{1, 2, 4}));
}

TEST(VolumeFormats, files_without_a_telling_name_are_known_by_their_content)
{
    const std::string bytes = to_bytes(ramp<std::uint8_t>(), kLittle);
    EXPECT_EQ(
        read_content("scan", nrrd_of({"type: uchar", "dimension: 3", "sizes: 6 5 4", "encoding: raw"}, bytes))
            .format,
        "NRRD");
    EXPECT_EQ(read_content("scan.dat", meta_of({"ElementType = MET_UCHAR"}, bytes)).format, "MetaImage");
    EXPECT_EQ(read_content("scan.x", inr_of("unsigned fixed", 1, "pc", bytes)).format, "Inrimage");
    EXPECT_EQ(
        read_content("scan.xml", vti_of("0 5 0 4 0 3", "type=\"UInt8\"", "Spacing=\"1 1 1\"", bytes)).format,
        "VTK image data");
    EXPECT_EQ(
        read_content("scan.lsm", tiff_of({.bits = 8}, {bytes.substr(0, 30), bytes.substr(30, 30)})).format,
        "TIFF");
}

TEST(VolumeFormats, legacy_vtk_structured_points_are_read)
{
    const std::vector<std::uint16_t> samples = ramp<std::uint16_t>();
    const std::string head =
        "# vtk DataFile Version 3.0\ntitle\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 6 5 4\n"
        "ORIGIN 1 2 3\nSPACING 1 2 3\nPOINT_DATA 120\nSCALARS s unsigned_short 1\n"
        "LOOKUP_TABLE default\n";
    const std::string bytes = to_bytes(samples, kBig);
    const ReadVolume read = read_content("v.vtk", head + bytes);
    expect_values(read, samples, "VTK image data");
    EXPECT_EQ(read.volume.geometry.world_from_grid.translation, (Point3{1, 2, 3}));
    expect_has(refusal("v.vtk", head + bytes.substr(0, 190)), "truncated");
}

TEST(VolumeFormats, masks_of_one_bit_are_unpacked)
{
    // 6 samples in a row of one byte: 0b101100xx
    const std::string page(5, static_cast<char>(0b10110000));
    const ReadVolume read = read_content("v.tif", tiff_of({.bits = 1}, {page, page}));
    const std::vector<double> row{1, 0, 1, 1, 0, 0};
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(read.volume.at(i, 2, 1), row[i]);
}

} // namespace

} // namespace voroprobe
