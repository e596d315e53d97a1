//! Real scans. Those of testdata/ are always there; the others are skipped where there is no folder of them.

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <ostream>

#include <gtest/gtest.h>

#include "volume/statistics.h"
#include "volume_expectations.h"
#include "volume_files.h"

namespace voroprobe
{

namespace
{

std::filesystem::path data_folder()
{
    if (const char* folder = std::getenv("VOROPROBE_DATA"))
        return folder;
    return std::filesystem::path(VOROPROBE_SOURCE_DIR) / ".." / "shared" / "data";
}

std::filesystem::path testdata_folder()
{
    return std::filesystem::path(VOROPROBE_SOURCE_DIR) / "testdata";
}

struct Scan
{
    const char* name;
    std::array<std::size_t, 3> size;
    Vec3 spacing;
    const char* stored_type;
    double min;
    double max;
};

//! How tests name it where they are skipped; gtest would show its bytes.
void PrintTo(const Scan& scan, std::ostream* out)
{
    *out << scan.name;
}

//! As measured by others when the scans were collected.
const std::vector<Scan>& scans()
{
    static const std::vector<Scan> all{
        {"cranium_ct.nrrd", {256, 256, 108}, {0.957, 0.957, 1.5}, "int16", -1024, 2986},
        {"headsq_ct.nrrd", {64, 64, 93}, {3.2, 3.2, 1.5}, "int16", 0, 3926},
        {"skull_cgal.nrrd", {64, 64, 64}, {3.943, 3.943, 3.651}, "float32", 0, 5.43},
        {"tooth_ct.nrrd", {103, 94, 161}, {1, 1, 1}, "uint16", 0, 1300},
        {"engine_ct.nii.gz", {256, 256, 128}, {1, 1, 1}, "uint8", 0, 255},
        {"bonsai_ct.nii.gz", {256, 256, 256}, {1, 1, 1}, "uint8", 0, 255},
        {"head_mri.nii.gz", {160, 232, 160}, {1, 0.898, 0.898}, "uint8", 0, 512},
        {"head_ct_oblique.nii.gz", {175, 248, 58}, {0.8125, 0.8125, 2.397}, "uint8", 0, 255},
        {"mra_vessels.nii.gz", {200, 256, 120}, {0.521, 0.521, 0.65}, "uint8", 0, 254},
        {"aorta_angio.mha", {157, 393, 34}, {0.879, 0.879, 1.5}, "float32", 0, 2570.2},
        {"aorta_levelset.mha", {157, 393, 34}, {0.879, 0.879, 1.5}, "float32", -3.52, 3.52},
        {"marschner_lobb.mha", {43, 43, 43}, {1, 1, 1}, "uint8", 0, 255},
        {"fuel.mha", {68, 68, 68}, {1, 1, 1}, "uint8", 0, 255},
        {"neghip.mha", {70, 70, 70}, {1, 1, 1}, "uint8", 0, 255},
        {"silicium.mha", {104, 40, 40}, {1, 1, 1}, "uint8", 0, 255},
        {"fiberform_microct.tif", {100, 100, 100}, {1, 1, 1}, "uint8", 0, 255},
        {"vase_ct.vti", {115, 101, 75}, {1, 1, 1}, "uint8", 0, 239},
        {"pet_dicom", {128, 128, 299}, {3.538, 3.538, 3.375}, "int16", 0, 66261},
        {"liver_labels.nrrd", {438, 353, 165}, {0.617, 0.617, 1.333}, "uint8", 0, 255},
        {"allen_labels.nii.gz", {318, 388, 310}, {0.5, 0.5, 0.5}, "uint8", 0, 141},
        {"inia19_labels.nii.gz", {168, 206, 128}, {0.5, 0.5, 0.5}, "int16", 0, 1605},
        {"frog_tissue_labels.mha", {500, 470, 136}, {1, 1, 1.5}, "uint8", 0, 29},
        {"platynereis_nuclei_labels.nrrd", {256, 256, 103}, {1, 1, 1}, "uint8", 0, 33}};
    return all;
}

void expect_is_as_described(const std::filesystem::path& path, const Scan& scan)
{
    SCOPED_TRACE(scan.name);
    const ReadVolume read = read_volume(path);
    EXPECT_EQ(read.volume.geometry.size, scan.size);
    EXPECT_EQ(read.stored_type, scan.stored_type);
    constexpr double kDescribedDigits = 1.1e-3; // spacings are described to three decimals
    for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(read.volume.geometry.spacing[axis], scan.spacing[axis], kDescribedDigits);
    const VolumeStatistics statistics = compute_statistics(read.volume);
    const double rounding = 1e-2 + 1e-5 * scan.max;
    EXPECT_NEAR(statistics.min, scan.min, rounding);
    EXPECT_NEAR(statistics.max, scan.max, rounding);
    EXPECT_EQ(statistics.nan_count, 0U);
}

TEST(RealScans, those_of_testdata_are_as_described)
{
    std::size_t found = 0;
    for (const Scan& scan : scans())
        if (const auto path = testdata_folder() / scan.name; std::filesystem::exists(path))
        {
            expect_is_as_described(path, scan);
            ++found;
        }
    EXPECT_EQ(found, 5U);
}

class SharedScan : public testing::TestWithParam<Scan>
{
};

TEST_P(SharedScan, is_as_described)
{
    const auto path = data_folder() / GetParam().name;
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << path << " is not there";
    expect_is_as_described(path, GetParam());
}

std::string test_name(const testing::TestParamInfo<Scan>& info)
{
    std::string name = info.param.name;
    return name.substr(0, name.find('.'));
}

INSTANTIATE_TEST_SUITE_P(RealScans, SharedScan, testing::ValuesIn(scans()), test_name);

std::string unpacked(const std::filesystem::path& path)
{
    return gunzip_of(content_of(path));
}

template <class Number>
Number number_at(const std::string& bytes, std::size_t offset)
{
    Number number{};
    std::memcpy(&number, bytes.data() + offset, sizeof(Number));
    return number;
}

//! The header's own arithmetic: RAS position of a voxel by the rows of the sform, turned to LPS.
Point3 position_by_sform(const std::string& header, const Point3& p_source_index)
{
    Point3 p_world;
    for (std::size_t row = 0; row < 3; ++row)
    {
        double sum = number_at<float>(header, 280 + 16 * row + 12);
        for (std::size_t axis = 0; axis < 3; ++axis)
            sum += double{number_at<float>(header, 280 + 16 * row + 4 * axis)} * p_source_index[axis];
        p_world[row] = row < 2 ? -sum : sum;
    }
    return p_world;
}

TEST(RealScans, the_oblique_head_lands_where_its_header_says)
{
    const auto path = testdata_folder() / "head_ct_oblique.nii.gz";
    const std::string file = unpacked(path);
    ASSERT_GT(number_at<std::int16_t>(file, 254), 0) << "has an sform";
    const Volume volume = read_volume(path).volume;
    const GridGeometry& geometry = volume.geometry;
    const Vec3 far = geometry.grid_box().max;
    constexpr double kFloatRounding = 1e-3; // mm, of the floats of the header over 250 voxels
    for (unsigned corner = 0; corner < 8; ++corner)
    {
        const Point3 p_grid{(corner & 1U) != 0 ? far.x : 0.0, (corner & 2U) != 0 ? far.y : 0.0,
                            (corner & 4U) != 0 ? far.z : 0.0};
        const Point3 p_source = geometry.source_index_from_grid * p_grid;
        EXPECT_LT(distance(geometry.world_from_grid * p_grid, position_by_sform(file, p_source)),
                  kFloatRounding);

        const auto index = [&](std::size_t axis)
        { return static_cast<std::size_t>(std::lround(p_source[axis])); };
        const std::size_t offset = 352 + index(0) + 175 * (index(1) + 248 * index(2));
        const auto at = [&](std::size_t axis) { return p_grid[axis] > 0.0 ? geometry.size[axis] - 1 : 0; };
        EXPECT_EQ(volume.at(at(0), at(1), at(2)), static_cast<unsigned char>(file[offset]));
    }
}

//! Value of a data element in implicit little endian, found by its tag; empty where it is not there.
std::string implicit_element(const std::string& file, std::uint16_t group, std::uint16_t element)
{
    const std::size_t at = file.find(to_bytes(group, kLittle) + to_bytes(element, kLittle), 132);
    if (at == std::string::npos)
        return "";
    return file.substr(at + 8, number_at<std::uint32_t>(file, at + 4));
}

std::vector<double> decimals(const std::string& text)
{
    std::vector<double> numbers;
    std::istringstream stream(text);
    for (std::string one; std::getline(stream, one, '\\');)
        numbers.push_back(std::stod(one));
    return numbers;
}

TEST(RealScans, the_pet_series_lands_where_its_slices_say)
{
    const auto folder = data_folder() / "pet_dicom";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << folder << " is not there";
    std::map<double, std::string> file_at_height;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        const std::string file = content_of(entry.path());
        const std::vector<double> position = decimals(implicit_element(file, 0x20, 0x32));
        ASSERT_EQ(position.size(), 3U);
        file_at_height[position[2]] = file;
    }
    const Volume volume = read_volume(folder).volume;
    const GridGeometry& geometry = volume.geometry;
    ASSERT_EQ(file_at_height.size(), geometry.size[2]);

    std::size_t k = 0;
    for (const auto& [height, file] : file_at_height)
    {
        const std::vector<double> position = decimals(implicit_element(file, 0x20, 0x32));
        const Point3 p_grid{0, 0, static_cast<double>(k) * geometry.spacing.z};
        EXPECT_LT(distance(geometry.world_from_grid * p_grid, {position[0], position[1], position[2]}), 1e-3)
            << k;

        const double slope = std::stod(implicit_element(file, 0x28, 0x1053));
        const std::string pixels = file.substr(file.size() - std::size_t{2} * 128 * 128);
        for (const std::size_t i : {0U, 40U, 64U, 127U})
        {
            const auto stored = number_at<std::int16_t>(pixels, 2 * (i + 128 * 70));
            EXPECT_NEAR(volume.at(i, 70, k), slope * stored, 1e-6 * slope * std::abs(stored) + 1e-9) << k;
        }
        ++k;
    }
}

} // namespace

} // namespace voroprobe
