#include "volume/inventory.h"

#include <map>
#include <memory>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "inventory_reference.h"
#include "tests/mesher/random_volumes.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

//! A scan and its inventory.
struct Listed
{
    std::unique_ptr<HeightField> field;
    std::unique_ptr<Inventory> inventory;

    [[nodiscard]] const std::vector<ScanSurface>& surfaces() const { return inventory->surfaces(); }
};

Listed list(std::shared_ptr<const Volume> volume, double isovalue, std::size_t threads = 1)
{
    Listed listed;
    listed.field = make_height_field(level_volume(std::move(volume), isovalue));
    listed.inventory = std::make_unique<Inventory>(*listed.field, threads);
    return listed;
}

Listed list(const LevelFunction& function, const std::array<std::size_t, 3>& size,
            const Vec3& spacing = {1, 1, 1})
{
    return list(std::make_shared<Volume>(sample_volume(function, size, spacing)), 0.0);
}

long total_euler_characteristic(const Inventory& inventory)
{
    long sum = 0;
    for (const ScanSurface& surface : inventory.surfaces())
        sum += surface.euler_characteristic;
    return sum;
}

template <class Visit>
void for_each_sample(const Inventory& inventory, Visit visit)
{
    const auto [columns, rows, slices] = inventory.runs().sample_count();
    for (int k = 0; k < slices; ++k)
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i)
                visit(std::array<int, 3>{i, j, k});
}

//! Neighbouring samples are of one region or of two that a surface separates: the regions form a tree.
void expect_tree(const Inventory& inventory)
{
    EXPECT_EQ(inventory.surfaces().size() + 1,
              inventory.inside_region_count() + inventory.outside_region_count());
    for_each_sample(inventory,
                    [&](const std::array<int, 3>& at)
                    {
                        const Region here = inventory.region(at[0], at[1], at[2]);
                        for (std::size_t axis = 0; axis < 3; ++axis)
                            for (const int step : {-1, 1})
                            {
                                std::array<int, 3> next = at;
                                next[axis] += step;
                                const Region there = inventory.region(next[0], next[1], next[2]);
                                EXPECT_NE(here == there,
                                          inventory.surface_between(here, there) != kNoSurface);
                            }
                    });
}

//! What each surface says of itself, checked against the samples' regions.
void expect_consistent_surfaces(const Listed& listed)
{
    const Inventory& inventory = *listed.inventory;
    const auto domain = listed.field->frame();
    std::map<Region, std::size_t> samples;
    for_each_sample(inventory,
                    [&](const std::array<int, 3>& at) { ++samples[inventory.region(at[0], at[1], at[2])]; });
    std::vector<std::size_t> enclosed(inventory.surfaces().size());
    for (const auto& [region, count] : samples)
        for (SurfaceId id = inventory.surface_around(region); id != kNoSurface;
             id = inventory.surfaces()[static_cast<std::size_t>(id)].parent)
            enclosed[static_cast<std::size_t>(id)] += count;
    for (std::size_t id = 0; id < inventory.surfaces().size(); ++id)
    {
        const ScanSurface& surface = inventory.surfaces()[id];
        EXPECT_TRUE(is_inside(surface.inside));
        EXPECT_FALSE(is_inside(surface.outside));
        EXPECT_EQ(inventory.surface_between(surface.inside, surface.outside), static_cast<SurfaceId>(id));
        EXPECT_EQ(inventory.surface_between(surface.outside, surface.inside), static_cast<SurfaceId>(id));
        const Region enclosing = surface.cavity ? surface.inside : surface.outside;
        EXPECT_EQ(surface.parent, inventory.surface_around(enclosing));
        EXPECT_LT(surface.parent, static_cast<SurfaceId>(id));
        EXPECT_EQ(surface.enclosed_samples, enclosed[id]);
        EXPECT_GT(surface.enclosed_samples, 0U);
        EXPECT_TRUE(surface.box.contains(surface.point));
        EXPECT_FALSE(surface.touches_border && surface.cavity);
        EXPECT_EQ(surface.euler_characteristic % 2, 0);
        EXPECT_LE(surface.euler_characteristic, 2);
        if (surface.parent != kNoSurface)
        {
            const Box3& around = inventory.surfaces()[static_cast<std::size_t>(surface.parent)].box;
            EXPECT_GE(surface.box.min.x, around.min.x);
            EXPECT_LE(surface.box.max.z, around.max.z);
        }
    }
    EXPECT_EQ(domain.sample_count, inventory.runs().sample_count());
}

//! The inventory's regions are the reference's, one to one.
void expect_regions_of(InventoryReference& reference, const Inventory& inventory)
{
    EXPECT_EQ(inventory.surfaces().size() + 1, reference.region_count());
    std::map<Region, std::uint32_t> named;
    std::set<std::uint32_t> names;
    named[kOuterRegion] = reference.region({-1, 0, 0});
    names.insert(named[kOuterRegion]);
    for_each_sample(inventory,
                    [&](const std::array<int, 3>& at)
                    {
                        const Region region = inventory.region(at[0], at[1], at[2]);
                        EXPECT_EQ(is_inside(region), reference.height(at) >= 0.0);
                        const auto [known, is_new] = named.emplace(region, reference.region(at));
                        EXPECT_EQ(known->second, reference.region(at));
                        EXPECT_TRUE(!is_new || names.insert(known->second).second);
                    });
}

//! Few values: saddles of value 0, and different events at one place. The rest is in general position.
double raise_for(VolumeKind kind)
{
    switch (kind)
    {
    case VolumeKind::kIntegers:
    case VolumeKind::kSpecks:
    case VolumeKind::kCheckerboard:
    case VolumeKind::kThinSheets:
        return 1e-5; // below all saddles of such values that are not 0, above rounding
    default:
        return 0.0;
    }
}

class InventoryOfKind : public testing::TestWithParam<VolumeKind>
{
};

INSTANTIATE_TEST_SUITE_P(RandomVolumes, InventoryOfKind,
                         testing::Values(VolumeKind::kWhiteNoise, VolumeKind::kSmoothNoise,
                                         VolumeKind::kIntegers, VolumeKind::kSpecks,
                                         VolumeKind::kCheckerboard, VolumeKind::kThinSheets,
                                         VolumeKind::kAnisotropic, VolumeKind::kThroughBorder),
                         [](const auto& kind) { return name_of(kind.param); });

TEST_P(InventoryOfKind, is_that_of_the_reference)
{
    for (std::uint64_t seed = 0; seed < 40; ++seed)
    {
        const RandomVolume random = make_random_volume(GetParam(), seed);
        SCOPED_TRACE(random.name);
        const Listed listed = list(random.volume, random.isovalue);
        InventoryReference reference(*listed.field, raise_for(GetParam()));
        expect_regions_of(reference, *listed.inventory);
        expect_tree(*listed.inventory);
        expect_consistent_surfaces(listed);
        EXPECT_EQ(total_euler_characteristic(*listed.inventory), reference.euler_characteristic());
        if (HasFailure())
            return;
    }
}

TEST_P(InventoryOfKind, is_the_same_for_any_number_of_threads)
{
    const RandomVolume random = make_random_volume(GetParam(), 100);
    const Listed one = list(random.volume, random.isovalue, 1);
    for (const std::size_t threads : {0U, 2U, 5U})
    {
        const Listed other = list(random.volume, random.isovalue, threads);
        ASSERT_EQ(other.surfaces().size(), one.surfaces().size());
        for (std::size_t id = 0; id < one.surfaces().size(); ++id)
        {
            EXPECT_EQ(other.surfaces()[id].inside, one.surfaces()[id].inside);
            EXPECT_EQ(other.surfaces()[id].outside, one.surfaces()[id].outside);
            EXPECT_EQ(other.surfaces()[id].point, one.surfaces()[id].point);
            EXPECT_EQ(other.surfaces()[id].box.min, one.surfaces()[id].box.min);
            EXPECT_EQ(other.surfaces()[id].box.max, one.surfaces()[id].box.max);
            EXPECT_EQ(other.surfaces()[id].euler_characteristic, one.surfaces()[id].euler_characteristic);
        }
    }
}

TEST_P(InventoryOfKind, points_on_surfaces_are_on_them)
{
    const RandomVolume random = make_random_volume(GetParam(), 7);
    const Listed listed = list(random.volume, random.isovalue);
    std::vector<SurfaceId> ids;
    for (std::size_t id = 0; id < listed.surfaces().size(); ++id)
        ids.push_back(static_cast<SurfaceId>(id));
    constexpr std::size_t kMost = 5;
    const auto points = grid_crossings(*listed.field, *listed.inventory, ids, kMost);
    const auto all = grid_crossings(*listed.field, *listed.inventory, ids, 1000000);
    for (std::size_t id = 0; id < ids.size(); ++id)
    {
        const Box3 box = listed.surfaces()[id].box.expanded(1e-9);
        Box3 of_all;
        for (const Point3& p : all[id])
            of_all.include(p);
        EXPECT_EQ(points[id].size(), std::min(kMost, all[id].size()));
        EXPECT_EQ(of_all.min, listed.surfaces()[id].box.min);
        EXPECT_EQ(of_all.max, listed.surfaces()[id].box.max);
        for (const Point3& p : points[id])
            EXPECT_TRUE(box.contains(p));
    }
}

TEST(Inventory, nested_shells_are_a_chain_of_spheres)
{
    const Listed listed = list(nested_shells_phantom({15, 15, 15}, {13.0, 10.0, 7.0, 4.0}), {31, 31, 31});
    ASSERT_EQ(listed.surfaces().size(), 4U);
    EXPECT_EQ(listed.inventory->inside_region_count(), 2U);
    EXPECT_EQ(listed.inventory->outside_region_count(), 3U);
    for (SurfaceId id = 0; id < 4; ++id)
    {
        const ScanSurface& surface = listed.surfaces()[static_cast<std::size_t>(id)];
        EXPECT_EQ(surface.parent, id - 1);
        EXPECT_EQ(surface.cavity, id % 2 == 1);
        EXPECT_EQ(surface.euler_characteristic, 2);
        EXPECT_FALSE(surface.touches_border);
        const double radius = 13.0 - 3.0 * id;
        EXPECT_NEAR(surface.box.extent().x, 2.0 * radius, 0.2);
        const double volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
        EXPECT_NEAR(static_cast<double>(surface.enclosed_samples), volume, 0.1 * volume);
    }
}

TEST(Inventory, a_torus_has_euler_characteristic_0_and_a_double_torus_minus_2)
{
    const Listed torus = list(torus_phantom({15, 15, 8}, 9.0, 3.5), {31, 31, 17});
    ASSERT_EQ(torus.surfaces().size(), 1U);
    EXPECT_EQ(torus.surfaces()[0].euler_characteristic, 0);
    const Listed two = list(double_torus_phantom({33, 21, 6}, 30.0), {67, 43, 13});
    ASSERT_EQ(two.surfaces().size(), 1U);
    EXPECT_EQ(two.surfaces()[0].euler_characteristic, -2);
}

TEST(Inventory, spacing_changes_places_but_no_surface)
{
    const auto foam = [](const Vec3& spacing)
    {
        return [spacing](const Point3& p)
        {
            return std::sin(1.1 * p.x / spacing.x) + std::sin(0.9 * p.y / spacing.y) +
                   std::sin(1.3 * p.z / spacing.z) + 0.3;
        };
    };
    const Listed even = list(foam({1, 1, 1}), {20, 21, 22});
    const Listed stretched = list(foam({1, 1, 8}), {20, 21, 22}, {1, 1, 8});
    ASSERT_EQ(stretched.surfaces().size(), even.surfaces().size());
    for (std::size_t id = 0; id < even.surfaces().size(); ++id)
    {
        EXPECT_EQ(stretched.surfaces()[id].euler_characteristic, even.surfaces()[id].euler_characteristic);
        EXPECT_NEAR(stretched.surfaces()[id].box.max.z, 8.0 * even.surfaces()[id].box.max.z, 1e-4);
    }
}

TEST(Inventory, a_volume_inside_throughout_is_one_sphere_of_caps)
{
    const Listed listed = list([](const Point3&) { return 1.0; }, {3, 4, 5});
    ASSERT_EQ(listed.surfaces().size(), 1U);
    EXPECT_EQ(listed.surfaces()[0].euler_characteristic, 2);
    EXPECT_TRUE(listed.surfaces()[0].touches_border);
    EXPECT_EQ(listed.surfaces()[0].enclosed_samples, 60U);
    EXPECT_EQ(listed.surfaces()[0].box.max, (Point3{2, 3, 4}));
}

TEST(Inventory, a_volume_outside_throughout_has_no_surface)
{
    const Listed listed = list([](const Point3&) { return -1.0; }, {3, 4, 5});
    EXPECT_TRUE(listed.surfaces().empty());
    EXPECT_EQ(listed.inventory->region(1, 1, 1), kOuterRegion);
}

TEST(Inventory, a_tube_through_the_volume_is_closed_by_caps_to_a_sphere)
{
    const Listed listed =
        list([](const Point3& p) { return 3.3 - std::hypot(p.y - 6.0, p.z - 6.0); }, {5, 13, 13});
    ASSERT_EQ(listed.surfaces().size(), 1U);
    EXPECT_EQ(listed.surfaces()[0].euler_characteristic, 2);
    EXPECT_TRUE(listed.surfaces()[0].touches_border);
}

TEST(Inventory, a_hole_through_the_volume_makes_a_torus_of_its_border)
{
    const Listed listed =
        list([](const Point3& p) { return std::hypot(p.y - 6.0, p.z - 6.0) - 3.3; }, {5, 13, 13});
    ASSERT_EQ(listed.surfaces().size(), 1U);
    EXPECT_EQ(listed.inventory->outside_region_count(), 1U);
    EXPECT_EQ(listed.surfaces()[0].euler_characteristic, 0);
}

TEST(Inventory, samples_equal_to_the_isovalue_are_inside)
{
    auto volume = std::make_shared<Volume>(sample_volume(
        [](const Point3& p) {
            return p == Point3{2, 2, 2} ? 5.0 : 0.0;
        },
        {5, 5, 5}, {1, 1, 1}));
    const Listed listed = list(volume, 5.0);
    ASSERT_EQ(listed.surfaces().size(), 1U);
    EXPECT_EQ(listed.surfaces()[0].enclosed_samples, 1U);
    EXPECT_EQ(listed.surfaces()[0].euler_characteristic, 2);
}

TEST(Inventory, memory_stays_below_a_byte_per_sample_where_surfaces_are_smooth)
{
    const Listed listed = list(nested_shells_phantom({32, 32, 32}, {30.0, 20.0, 10.0}), {65, 65, 65});
    EXPECT_LT(listed.inventory->memory_bytes(), 65U * 65U * 65U);
}

} // namespace
} // namespace voroprobe
