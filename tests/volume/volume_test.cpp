#include "volume/volume.h"

#include <gtest/gtest.h>

#include "stored_orders.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

constexpr double kRounding = 1e-9; // mm

//! Every sample of `volume` is bit for bit that of the phantom, and stands where the phantom has it.
void expect_is(const Volume& volume, const Phantom& phantom)
{
    ASSERT_EQ(volume.geometry.size, phantom.size);
    for (std::size_t k = 0; k < phantom.size[2]; ++k)
        for (std::size_t j = 0; j < phantom.size[1]; ++j)
            for (std::size_t i = 0; i < phantom.size[0]; ++i)
            {
                ASSERT_EQ(volume.at(i, j, k), phantom.value(i, j, k));
                const Vec3& spacing = volume.geometry.spacing;
                const Point3 p_grid{static_cast<double>(i) * spacing.x, static_cast<double>(j) * spacing.y,
                                    static_cast<double>(k) * spacing.z};
                ASSERT_LT(distance(volume.geometry.world_from_grid * p_grid, phantom.position(i, j, k)),
                          kRounding);
            }
}

TEST(Volume, every_order_of_the_axes_gives_the_same_samples_in_the_same_places)
{
    for (const Matrix3& rotation :
         {Matrix3{}, rotation_about({1, 0, 0}, 16.5), rotation_about({1, 2, 3}, -20.0)})
        for (const std::array<std::ptrdiff_t, 3>& start :
             {std::array<std::ptrdiff_t, 3>{0, 0, 0}, {4, -9, 100}})
            for (const StoredOrder& order : all_orders(start))
            {
                const Phantom phantom{.rotation = rotation};
                StoredImage image = store(phantom, order);
                expect_is(make_volume(image.lattice, std::move(image.samples)), phantom);
            }
}

TEST(Volume, source_indices_name_the_stored_sample)
{
    const Phantom phantom;
    for (const StoredOrder& order : all_orders())
    {
        const StoredImage image = store(phantom, order);
        const Volume volume = make_volume(image.lattice, image.samples);
        const Point3 p_source = volume.geometry.source_index_from_grid *
                                Point3{2 * phantom.spacing.x, 3 * phantom.spacing.y, 4 * phantom.spacing.z};
        const auto index = [&](std::size_t axis)
        { return static_cast<std::size_t>(std::lround(p_source[axis])); };
        const std::size_t offset =
            index(0) + image.lattice.size[0] * (index(1) + image.lattice.size[1] * index(2));
        EXPECT_EQ(image.samples[offset], volume.at(2, 3, 4));
    }
}

TEST(Volume, samples_in_canonical_order_are_not_copied)
{
    StoredImage image = store({}, all_orders().front());
    const std::int16_t* stored = image.samples.data();
    const Volume volume = make_volume(image.lattice, std::move(image.samples));
    EXPECT_EQ(std::get<std::vector<std::int16_t>>(volume.samples).data(), stored);
}

TEST(Volume, the_number_of_samples_has_to_fit_the_size)
{
    EXPECT_THROW(make_volume({.size = {2, 2, 2}}, std::vector<float>(7)), InputError);
    EXPECT_THROW(make_volume({.size = {2, 2, 2}}, std::vector<float>(9)), InputError);
    constexpr std::size_t kHalf = std::size_t{1} << 32U; // kHalf^2 overflows to 0
    EXPECT_THROW(make_volume({.size = {kHalf, kHalf, 1}}, std::vector<float>{}), InputError);
}

TEST(Volume, type_names_are_those_of_the_array)
{
    EXPECT_EQ(sample_type_name(std::vector<std::uint8_t>{}), "uint8");
    EXPECT_EQ(sample_type_name(std::vector<std::int8_t>{}), "int8");
    EXPECT_EQ(sample_type_name(std::vector<std::uint16_t>{}), "uint16");
    EXPECT_EQ(sample_type_name(std::vector<std::int16_t>{}), "int16");
    EXPECT_EQ(sample_type_name(std::vector<std::int32_t>{}), "int32");
    EXPECT_EQ(sample_type_name(std::vector<float>{}), "float32");
    EXPECT_EQ(sample_type_name(std::vector<double>{}), "float64");
}

} // namespace

} // namespace voroprobe
