// The trilinear oracle with an inventory.

#include <gtest/gtest.h>

#include "concurrent_queries.h"
#include "oracle_laws.h"
#include "oracles/trilinear_oracle.h"
#include "support/error.h"
#include "tests/mesher/random_volumes.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

struct Listed
{
    LevelledVolume levelled;
    std::shared_ptr<const Inventory> inventory;
    std::unique_ptr<SurfaceOracle> oracle;
};

Listed list(std::shared_ptr<const Volume> volume, double isovalue)
{
    Listed listed;
    listed.levelled = level_volume(std::move(volume), isovalue);
    listed.inventory = std::make_shared<const Inventory>(*make_height_field(listed.levelled));
    listed.oracle = make_trilinear_oracle(listed.levelled, listed.inventory);
    return listed;
}

Listed shells()
{
    const auto phantom = nested_shells_phantom({15, 15, 15}, {13.0, 10.0, 7.0, 4.0});
    return list(std::make_shared<Volume>(sample_volume(phantom, {31, 31, 31}, {1, 1, 1})), 0.0);
}

class TrilinearRegionsOfKind : public testing::TestWithParam<VolumeKind>
{
};

INSTANTIATE_TEST_SUITE_P(RandomVolumes, TrilinearRegionsOfKind,
                         testing::Values(VolumeKind::kWhiteNoise, VolumeKind::kSmoothNoise,
                                         VolumeKind::kIntegers, VolumeKind::kSpecks,
                                         VolumeKind::kCheckerboard, VolumeKind::kThinSheets,
                                         VolumeKind::kAnisotropic, VolumeKind::kThroughBorder),
                         [](const auto& kind) { return name_of(kind.param); });

TEST_P(TrilinearRegionsOfKind, change_at_crossings_only_and_there_across_the_crossing_s_surface)
{
    for (std::uint64_t seed = 0; seed < 10; ++seed)
    {
        const RandomVolume random = make_random_volume(GetParam(), seed);
        SCOPED_TRACE(random.name);
        expect_region_laws_on_random_segments(*list(random.volume, random.isovalue).oracle, seed, 2'000);
    }
}

TEST_P(TrilinearRegionsOfKind, have_the_sides_of_the_plain_oracle)
{
    const RandomVolume random = make_random_volume(GetParam(), 50);
    const Listed listed = list(random.volume, random.isovalue);
    const auto plain = make_trilinear_oracle(random.volume, random.isovalue);
    Random points(1);
    for (int i = 0; i < 20'000; ++i)
    {
        const Point3 p = random_point(points, plain->domain().expanded(0.5));
        ASSERT_EQ(is_inside(listed.oracle->region(p)), is_inside(plain->region(p)));
    }
    expect_laws_on_random_segments(*listed.oracle, 2, 5'000);
}

TEST_P(TrilinearRegionsOfKind, points_on_a_surface_are_said_to_be_on_it)
{
    const RandomVolume random = make_random_volume(GetParam(), 51);
    const Listed listed = list(random.volume, random.isovalue);
    std::vector<SurfaceId> ids;
    for (std::size_t id = 0; id < listed.oracle->surface_count(); ++id)
        ids.push_back(static_cast<SurfaceId>(id));
    const auto points = listed.oracle->points_on(ids, 20);
    for (std::size_t id = 0; id < ids.size(); ++id)
    {
        EXPECT_FALSE(points[id].empty());
        for (const Point3& p : points[id])
            EXPECT_EQ(listed.oracle->surface_at(p), ids[id]);
    }
}

TEST_P(TrilinearRegionsOfKind, of_samples_are_the_inventory_s)
{
    const RandomVolume random = make_random_volume(GetParam(), 52);
    const Listed listed = list(random.volume, random.isovalue);
    const auto& size = listed.inventory->runs().sample_count();
    for (int k = 0; k < size[2]; ++k)
        for (int j = 0; j < size[1]; ++j)
            for (int i = 0; i < size[0]; ++i)
                ASSERT_EQ(listed.oracle->region(make_height_field(listed.levelled)->frame().at({i, j, k})),
                          listed.inventory->region(i, j, k));
}

TEST(TrilinearRegions, of_nested_shells_are_told_apart)
{
    const Listed listed = shells();
    const SurfaceOracle& oracle = *listed.oracle;
    ASSERT_EQ(oracle.surface_count(), 4U);
    EXPECT_EQ(oracle.region({15, 15, 1}), kOuterRegion);
    EXPECT_EQ(oracle.region({-5, 15, 15}), kOuterRegion);
    const Region shell = oracle.region({15, 15, 26.5});
    const Region gap = oracle.region({15, 15, 23.5});
    const Region middle = oracle.region({15, 15, 15});
    EXPECT_FALSE(is_inside(middle));
    EXPECT_NE(middle, kOuterRegion);
    EXPECT_NE(middle, gap);
    EXPECT_EQ(oracle.surface_around(shell), 0);
    EXPECT_EQ(oracle.surface_between(shell, gap), 1);
    EXPECT_EQ(oracle.surface_between(gap, middle), kNoSurface);
    EXPECT_EQ(oracle.surface_between(shell, middle), kNoSurface);
    EXPECT_EQ(oracle.sides(1).inside, shell);
    EXPECT_EQ(oracle.sides(1).outside, gap);
}

TEST(TrilinearRegions, without_an_inventory_are_the_sides)
{
    const Listed listed = shells();
    const auto plain = make_trilinear_oracle(listed.levelled, nullptr);
    EXPECT_EQ(plain->surface_count(), 0U);
    EXPECT_EQ(plain->region({15, 15, 26.5}), 1);
    EXPECT_EQ(plain->region({15, 15, 15}), kOuterRegion);
    EXPECT_EQ(plain->surface_between(1, kOuterRegion), 0);
}

TEST(TrilinearRegions, are_told_to_four_threads_at_once_as_to_one)
{
    expect_same_answers_from_four_threads(*shells().oracle, 20'000);
}

TEST(TrilinearRegions, of_another_volume_are_refused)
{
    const Listed listed = shells();
    const auto other =
        std::make_shared<Volume>(sample_volume([](const Point3&) { return 1.0; }, {31, 30, 31}, {1, 1, 1}));
    EXPECT_THROW(make_trilinear_oracle(level_volume(other, 0.0), listed.inventory), UsageError);
    EXPECT_THROW(make_trilinear_oracle(LevelledVolume{}, nullptr), UsageError);
}

} // namespace
} // namespace voroprobe
