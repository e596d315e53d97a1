//! One lattice of samples, stored in many ways, is the same volume in the same place.

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include "../volume/stored_orders.h"
#include "volume_expectations.h"
#include "volume_files.h"

namespace voroprobe
{

namespace
{

constexpr double kRounding = 1e-9;      // mm, of headers that hold all digits
constexpr double kFloatRounding = 2e-5; // mm, of headers that hold 32-bit floats

std::string exact(double value)
{
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
}

std::string exact(const Vec3& v, const char* separator)
{
    return exact(v.x) + separator + exact(v.y) + separator + exact(v.z);
}

std::string sizes(const StoredLattice& lattice)
{
    return std::to_string(lattice.size[0]) + " " + std::to_string(lattice.size[1]) + " " +
           std::to_string(lattice.size[2]);
}

std::string as_nrrd(const StoredImage& image)
{
    const StoredLattice& lattice = image.lattice;
    std::string directions = "space directions:";
    for (std::size_t axis = 0; axis < 3; ++axis)
        directions += " (" + exact(lattice.spacing[axis] * lattice.direction.column[axis], ",") + ")";
    return nrrd_of({"type: short", "dimension: 3", "space: left-posterior-superior",
                    "sizes: " + sizes(lattice), directions,
                    "space origin: (" + exact(lattice.origin, ",") + ")", "encoding: raw", "endian: big"},
                   to_bytes(image.samples, kBig));
}

std::string as_meta(const StoredImage& image)
{
    const StoredLattice& lattice = image.lattice;
    const auto& column = lattice.direction.column;
    return lines({"ObjectType = Image", "NDims = 3", "DimSize = " + sizes(lattice),
                  "ElementSpacing = " + exact(lattice.spacing, " "),
                  "TransformMatrix = " + exact(column[0], " ") + " " + exact(column[1], " ") + " " +
                      exact(column[2], " "),
                  "Offset = " + exact(lattice.origin, " "), "BinaryDataByteOrderMSB = False",
                  "ElementType = MET_SHORT", "ElementDataFile = LOCAL"}) +
           to_bytes(image.samples, kLittle);
}

std::string as_nifti(const StoredImage& image)
{
    const StoredLattice& lattice = image.lattice;
    NiftiHeader header{.size = {}, .order = kBig};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        header.size.push_back(static_cast<std::int16_t>(lattice.size[axis]));
        header.spacing[axis] = static_cast<float>(lattice.spacing[axis]);
    }
    for (std::size_t row = 0; row < 3; ++row)
    {
        const double ras = row < 2 ? -1.0 : 1.0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            header.sform.push_back(
                static_cast<float>(ras * lattice.spacing[axis] * lattice.direction.column[axis][row]));
        header.sform.push_back(static_cast<float>(ras * lattice.origin[row]));
    }
    return nifti_of(header, to_bytes(image.samples, kBig));
}

std::string as_vti(const StoredImage& image)
{
    const StoredLattice& lattice = image.lattice;
    std::string extent;
    for (std::size_t axis = 0; axis < 3; ++axis)
        extent += std::to_string(lattice.start[axis]) + " " +
                  std::to_string(lattice.start[axis] + static_cast<std::ptrdiff_t>(lattice.size[axis]) - 1) +
                  " ";
    std::string direction;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t axis = 0; axis < 3; ++axis)
            direction += exact(lattice.direction.column[axis][row]) + " ";
    return vti_of(extent, "type=\"Int16\"",
                  "Origin=\"" + exact(lattice.origin, " ") + "\" Spacing=\"" + exact(lattice.spacing, " ") +
                      "\" Direction=\"" + direction + "\"",
                  to_bytes(image.samples, kLittle));
}

//! The eight ways of the specification: upright, flipped, permuted, and of these two left-handed; each is
//! also tried with the whole lattice oblique.
const std::vector<StoredOrder>& eight_orders()
{
    static const std::vector<StoredOrder> orders{
        {"identity", {0, 1, 2}, {false, false, false}},
        {"two axes flipped", {0, 1, 2}, {true, true, false}},
        {"other two axes flipped", {0, 1, 2}, {false, true, true}},
        {"axes rotated", {1, 2, 0}, {false, false, false}},
        {"axes rotated and flipped", {2, 0, 1}, {true, false, true}},
        {"left-handed by a flip", {0, 1, 2}, {false, false, true}},
        {"left-handed by an exchange", {1, 0, 2}, {false, false, false}},
        {"non-zero start", {0, 1, 2}, {false, true, false}, {4, -7, 11}}};
    return orders;
}

void expect_is_phantom(const Volume& volume, const Phantom& phantom, double tolerance)
{
    ASSERT_EQ(volume.geometry.size, phantom.size);
    const Vec3& spacing = volume.geometry.spacing;
    for (std::size_t k = 0; k < phantom.size[2]; ++k)
        for (std::size_t j = 0; j < phantom.size[1]; ++j)
            for (std::size_t i = 0; i < phantom.size[0]; ++i)
            {
                ASSERT_EQ(volume.at(i, j, k), phantom.value(i, j, k));
                const Point3 p_grid{static_cast<double>(i) * spacing.x, static_cast<double>(j) * spacing.y,
                                    static_cast<double>(k) * spacing.z};
                ASSERT_LT(distance(volume.geometry.world_from_grid * p_grid, phantom.position(i, j, k)),
                          tolerance);
            }
    EXPECT_NEAR(determinant(volume.geometry.world_from_grid.linear), 1.0, 1e-12);
}

struct Container
{
    const char* file_name;
    std::string (*write)(const StoredImage&);
    double tolerance;
    bool has_start;
};

TEST(VolumeOrientation, every_orientation_in_every_format_is_the_same_volume)
{
    const std::vector<Container> containers{{"v.nrrd", as_nrrd, kRounding, false},
                                            {"v.mha", as_meta, kRounding, false},
                                            {"v.nii", as_nifti, kFloatRounding, false},
                                            {"v.vti", as_vti, kRounding, true}};
    for (const Matrix3& rotation :
         {Matrix3{}, rotation_about({1, 0, 0}, 16.5), rotation_about({2, -1, 3}, 35.0)})
        for (StoredOrder order : eight_orders())
            for (const Container& container : containers)
            {
                SCOPED_TRACE(std::string(order.name) + " in " + container.file_name);
                const Phantom phantom{.rotation = rotation};
                const std::array<std::ptrdiff_t, 3> start =
                    container.has_start ? order.start : StoredOrder{}.start;
                order.start = start;
                const ReadVolume read =
                    read_content(container.file_name, container.write(store(phantom, order)));
                expect_is_phantom(read.volume, phantom, container.tolerance);
                const Point3 first = read.volume.geometry.source_index_from_grid * Point3{0, 0, 0};
                for (std::size_t s = 0; s < 3; ++s)
                {
                    const double last = static_cast<double>(phantom.size[order.axis[s]] - 1);
                    EXPECT_NEAR(first[s], static_cast<double>(start[s]) + (order.reversed[s] ? last : 0.0),
                                kRounding);
                }
            }
}

} // namespace

} // namespace voroprobe
