#include "oracles/vdb_oracle.h"

#include <cstdlib>
#include <fstream>

#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>

#include "concurrent_queries.h"
#include "oracle_laws.h"
#include "support/error.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

using openvdb::Coord;
using openvdb::FloatGrid;

class VdbOracle : public testing::Test
{
protected:
    void SetUp() override
    {
        openvdb::initialize();
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) / (std::string("voroprobe_vdb_") + test->name());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::filesystem::path write(const openvdb::GridPtrVec& grids) const
    {
        auto path = folder_ / "grids.vdb";
        openvdb::io::File(path.string()).write(grids);
        return path;
    }

    [[nodiscard]] std::filesystem::path write_bytes(const std::string& bytes) const
    {
        auto path = folder_ / "bytes.vdb";
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }

    //! The message read_vdb_surface() refuses the file with.
    [[nodiscard]] static std::string refusal(const std::filesystem::path& path,
                                             const VdbOptions& options = {})
    {
        try
        {
            read_vdb_surface(path, options);
        }
        catch (const InputError& error)
        {
            return error.what();
        }
        return "";
    }

    std::filesystem::path folder_;
};

//! A fog ball: 1 in the middle, falling to 0 over two voxels around `radius`; all in voxels.
FloatGrid::Ptr fog_ball(const Coord& center, double radius)
{
    auto grid = FloatGrid::create(0.0F);
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    grid->setName("fog");
    auto accessor = grid->getAccessor();
    const int reach = static_cast<int>(radius) + 2;
    for (int x = -reach; x <= reach; ++x)
        for (int y = -reach; y <= reach; ++y)
            for (int z = -reach; z <= reach; ++z)
            {
                const double depth = radius - std::sqrt(double(x * x + y * y + z * z));
                const double value = std::clamp(0.5 + 0.5 * depth, 0.0, 1.0);
                if (value > 0.0)
                    accessor.setValue(center.offsetBy(x, y, z), static_cast<float>(value));
            }
    return grid;
}

//! Answers of a grid against those of the dense oracle on the same samples, moved by `first` voxels.
void expect_as_dense(const VdbSurface& surface, const FloatGrid& grid, const Vec3& voxel, std::uint64_t seed)
{
    openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
    box.expand(1);
    const auto accessor = grid.getConstAccessor();
    const Coord dim = box.dim();
    Volume volume = sample_volume([](const Point3&) { return 0.0; },
                                  {std::size_t(dim.x()), std::size_t(dim.y()), std::size_t(dim.z())}, voxel);
    auto& samples = std::get<std::vector<float>>(volume.samples);
    std::size_t at = 0;
    for (int z = 0; z < dim.z(); ++z)
        for (int y = 0; y < dim.y(); ++y)
            for (int x = 0; x < dim.x(); ++x)
                samples[at++] = accessor.getValue(box.min().offsetBy(x, y, z));
    const LevelledVolume levelled =
        level_volume(std::make_shared<Volume>(volume), surface.isovalue, surface.inside);
    const auto inventory =
        surface.inventory ? std::make_shared<const Inventory>(*make_height_field(levelled)) : nullptr;
    const auto dense = make_trilinear_oracle(levelled, inventory);
    ASSERT_EQ(surface.oracle->surface_count(), dense->surface_count());
    const Vec3 shift{voxel.x * box.min().x(), voxel.y * box.min().y(), voxel.z * box.min().z()};

    Random random(seed);
    std::vector<Crossing> crossings;
    std::vector<Crossing> expected;
    for (int i = 0; i < 5000; ++i)
    {
        const Segment3 segment = random_segment(random, dense->domain().expanded(2.0 * voxel.x));
        const Segment3 moved{segment.source + shift, segment.target + shift};
        dense->find_crossings(segment, expected);
        surface.oracle->find_crossings(moved, crossings);
        ASSERT_EQ(crossings.size(), expected.size());
        for (std::size_t c = 0; c < expected.size(); ++c)
        {
            ASSERT_NEAR(crossings[c].t, expected[c].t, 1e-9);
            ASSERT_EQ(surface.oracle->surface_at(crossings[c].point), dense->surface_at(expected[c].point));
        }
        ASSERT_EQ(surface.oracle->region(moved.source), dense->region(segment.source));
        Box3 around{segment.source, segment.source};
        around = around.expanded(voxel.x * random.uniform(0.1, 20.0));
        ASSERT_EQ(surface.oracle->may_cross({around.min + shift, around.max + shift}),
                  dense->may_cross(around));
    }
}

TEST_F(VdbOracle, the_sample_level_set_is_a_sphere_of_radius_3)
{
    const char* data = std::getenv("VOROPROBE_DATA");
    const std::filesystem::path path =
        std::filesystem::path(data ? data : VOROPROBE_SOURCE_DIR "/../shared/data") / "sphere_levelset.vdb";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "needs " << path;
    const VdbSurface surface = read_vdb_surface(path);
    EXPECT_EQ(surface.grid_name, "ls_sphere");
    EXPECT_EQ(surface.grid_class, "level set");
    EXPECT_EQ(surface.stored_type, "float16");
    EXPECT_EQ(surface.active_size, (std::array<std::size_t, 3>{125, 125, 125}));
    EXPECT_NEAR(surface.voxel_size, 0.05, 1e-6);
    EXPECT_EQ(surface.isovalue, 0.0);
    EXPECT_EQ(surface.inside, InsideIs::kBelow);
    EXPECT_EQ(surface.oracle->region({0, 0, 0}), 1) << "deep inside, in a tile without active voxels";

    // Half floats near the surface are good to 1e-4; the interpolant of a sphere's distance to h^2 / (4 r).
    constexpr double kTolerance = 1e-3;
    Random random(1);
    std::vector<Crossing> crossings;
    for (int i = 0; i < 2000; ++i)
    {
        const Vec3 along = normalized(random_point(random, {{-1, -1, -1}, {1, 1, 1}}));
        surface.oracle->find_crossings({-10.0 * along, 10.0 * along}, crossings);
        ASSERT_EQ(crossings.size(), 2U);
        for (const Crossing& crossing : crossings)
            ASSERT_NEAR(norm(surface.world_from_grid * crossing.point), 3.0, kTolerance);
        const double radius = random.uniform(0.0, 4.0);
        if (std::abs(radius - 3.0) > kTolerance)
        {
            ASSERT_EQ(is_inside(surface.oracle->region(radius * along)), radius < 3.0);
        }
    }
    expect_laws_on_random_segments(*surface.oracle, 2, 20'000);
}

TEST_F(VdbOracle, a_level_set_answers_as_its_dense_copy)
{
    const auto grid =
        openvdb::tools::createLevelSetSphere<FloatGrid>(12.3F, {-200.2F, 31.4F, 7.0F}, 0.5F, 3.0F);
    const VdbSurface surface = read_vdb_surface(write({grid}));
    EXPECT_EQ(surface.stored_type, "float32");
    expect_as_dense(surface, *grid, {0.5, 0.5, 0.5}, 3);
}

TEST_F(VdbOracle, a_fog_ball_at_negative_indices_answers_as_its_dense_copy)
{
    const auto grid = fog_ball({-300, 5, -77}, 11.3);
    const VdbSurface surface = read_vdb_surface(write({grid}));
    EXPECT_EQ(surface.grid_class, "fog volume");
    EXPECT_EQ(surface.isovalue, 0.5);
    EXPECT_EQ(surface.inside, InsideIs::kAbove);
    EXPECT_EQ(surface.max, 1.0);
    EXPECT_EQ(surface.oracle->region({-300, 5, -77}), 1);
    EXPECT_EQ(surface.oracle->region({-300, 5, -60}), kOuterRegion);
    expect_as_dense(surface, *grid, {1, 1, 1}, 4);
}

TEST_F(VdbOracle, surfaces_between_tiles_without_any_leaf_are_seen)
{
    // A box of tiles of 8^3 and 128^3 voxels beside the background.
    auto grid = FloatGrid::create(0.0F);
    grid->tree().addTile(2, Coord(0, 0, 0), 1.0F, true);
    grid->tree().addTile(1, Coord(128, 8, 16), 1.0F, true);
    const VdbSurface surface = read_vdb_surface(write({grid}));
    EXPECT_EQ(grid->tree().leafCount(), 0U);
    std::vector<Crossing> crossings;
    surface.oracle->find_crossings({{-50, 12, 20}, {300, 12, 20}}, crossings);
    ASSERT_EQ(crossings.size(), 2U);
    EXPECT_NEAR(crossings[0].point.x, -0.5, 1e-9);
    EXPECT_NEAR(crossings[1].point.x, 135.5, 1e-9);
    expect_as_dense(surface, *grid, {1, 1, 1}, 5);
}

TEST_F(VdbOracle, random_values_in_scattered_leaves_answer_as_their_dense_copy)
{
    auto grid = FloatGrid::create(-0.25F);
    auto accessor = grid->getAccessor();
    Random random(6);
    for (int i = 0; i < 3000; ++i)
        accessor.setValue(
            Coord(int(random.below(50)) - 25, int(random.below(40)) - 20, int(random.below(30))),
            static_cast<float>(random.below(5)));
    const VdbSurface surface = read_vdb_surface(write({grid}), {.isovalue = 2.0});
    EXPECT_EQ(surface.grid_class, "unknown");
    expect_as_dense(surface, *grid, {1, 1, 1}, 7);
    expect_laws_on_random_segments(*surface.oracle, 8, 20'000);

    const VdbSurface listed =
        read_vdb_surface(write({grid}), {.isovalue = 2.0, .regions = VdbRegions::kListed});
    EXPECT_GT(listed.inventory->surfaces().size(), 100U);
    expect_as_dense(listed, *grid, {1, 1, 1}, 7);
    expect_region_laws_on_random_segments(*listed.oracle, 9, 5'000);
}

TEST_F(VdbOracle, the_inventory_of_a_left_handed_grid_lies_where_its_oracle_has_it)
{
    const auto grid = fog_ball({20, -10, 5}, 6.0);
    auto matrix = openvdb::Mat4R::identity();
    matrix.preScale(openvdb::Vec3d(-0.5, 0.7, 2.0));
    grid->setTransform(openvdb::math::Transform::createLinearTransform(matrix));
    const VdbSurface surface = read_vdb_surface(write({grid}), {.regions = VdbRegions::kListed});
    ASSERT_EQ(surface.inventory->surfaces().size(), 1U);
    const ScanSurface& ball = surface.inventory->surfaces()[0];
    EXPECT_EQ(ball.euler_characteristic, 2);
    EXPECT_NEAR(ball.box.center().x, -0.5 * 20, 1e-9);
    EXPECT_EQ(surface.oracle->surface_at(ball.point), 0);
    expect_region_laws_on_random_segments(*surface.oracle, 3, 2'000);
}

TEST_F(VdbOracle, a_level_set_whose_inside_was_never_marked_is_filled)
{
    const auto grid = openvdb::tools::createLevelSetSphere<FloatGrid>(20.0F, {0, 0, 0}, 1.0F, 3.0F);
    for (auto off = grid->beginValueOff(); off; ++off)
        off.setValue(grid->background());
    const VdbSurface surface = read_vdb_surface(write({grid}));
    EXPECT_EQ(surface.oracle->region({1, 2, 3}), 1);
    std::vector<Crossing> crossings;
    surface.oracle->find_crossings({{-30, 0.1, 0.2}, {30, 0.3, 0.1}}, crossings);
    EXPECT_EQ(crossings.size(), 2U);
}

TEST_F(VdbOracle, a_rotated_left_handed_transform_leads_to_the_same_world)
{
    const auto grid = fog_ball({20, -10, 5}, 6.0);
    auto matrix = openvdb::Mat4R::identity();
    matrix.preScale(openvdb::Vec3d(-0.5, 0.7, 2.0));
    matrix.postRotate(openvdb::math::Z_AXIS, 0.6);
    matrix.postRotate(openvdb::math::X_AXIS, -0.3);
    matrix.postTranslate(openvdb::Vec3d(100, 200, 300));
    const auto transform = openvdb::math::Transform::createLinearTransform(matrix);
    grid->setTransform(transform);
    const VdbSurface surface = read_vdb_surface(write({grid}));

    EXPECT_NEAR(determinant(surface.world_from_grid.linear), 1.0, 1e-12);
    EXPECT_NEAR(surface.voxel_size, 0.5, 1e-12);
    Random random(9);
    for (int i = 0; i < 1000; ++i)
    {
        const Vec3 index{random.uniform(12, 28), random.uniform(-18, -2), random.uniform(-3, 13)};
        const openvdb::Vec3d world = transform->indexToWorld(openvdb::Vec3d(index.x, index.y, index.z));
        const Point3 p_grid = inverse(surface.world_from_grid) * Point3{world.x(), world.y(), world.z()};
        ASSERT_LT(distance(surface.source_index_from_grid * p_grid, index), 1e-9);
        const double radius = distance(index, {20, -10, 5});
        if (std::abs(radius - 6.0) > 0.1)
        {
            ASSERT_EQ(is_inside(surface.oracle->region(p_grid)), radius < 6.0);
        }
    }
    expect_laws_on_random_segments(*surface.oracle, 10, 20'000);
}

TEST_F(VdbOracle, values_that_are_not_finite_are_outside_and_counted)
{
    const auto grid = fog_ball({0, 0, 0}, 8.0);
    grid->getAccessor().setValue(Coord(0, 0, 0), std::numeric_limits<float>::quiet_NaN());
    const VdbSurface surface = read_vdb_surface(write({grid}));
    EXPECT_EQ(surface.warnings.size(), 1U);
    EXPECT_FALSE(is_inside(surface.oracle->region({0, 0, 0})));
    EXPECT_TRUE(is_inside(surface.oracle->region({1, 0, 0})));
}

TEST_F(VdbOracle, several_float_grids_are_listed_and_one_can_be_named)
{
    const auto first = fog_ball({0, 0, 0}, 5.0);
    const auto second = fog_ball({0, 0, 0}, 7.0);
    first->setName("density");
    second->setName("heat");
    const auto velocity = openvdb::Vec3SGrid::create();
    velocity->setName("v");
    const auto path = write({first, second, velocity});
    const std::string message = refusal(path);
    EXPECT_NE(message.find("density"), std::string::npos) << message;
    EXPECT_NE(message.find("heat"), std::string::npos) << message;
    EXPECT_NE(refusal(path, {.grid = "v"}).find("no float grid named \"v\""), std::string::npos);
    EXPECT_EQ(read_vdb_surface(path, {.grid = "heat"}).active_size[0], 15U)
        << "values reach 0 at 8 voxels from the center";
    EXPECT_NE(refusal(write({velocity})).find("no float grid"), std::string::npos);
}

TEST_F(VdbOracle, files_that_are_no_volume_are_refused_with_the_reason)
{
    EXPECT_NE(refusal(folder_ / "missing.vdb").find("no such file"), std::string::npos);
    EXPECT_NE(refusal(folder_).find("not a VDB file"), std::string::npos);
    EXPECT_NE(refusal(write_bytes("")).find("not a VDB file"), std::string::npos);
    EXPECT_NE(refusal(write_bytes("solid cube\nfacet normal 0 0 1\n")).find("not a VDB file"),
              std::string::npos);
    EXPECT_NE(refusal(write({FloatGrid::create(0.0F)})).find("no active voxel"), std::string::npos);
}

TEST_F(VdbOracle, a_truncated_file_is_refused_wherever_it_was_cut)
{
    const auto path = write({fog_ball({0, 0, 0}, 9.0)});
    std::ifstream file(path, std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(file)), {});
    for (std::size_t length = 4; length < whole.size(); length += length < 2000 ? 97 : 4001)
        ASSERT_NE(refusal(write_bytes(whole.substr(0, length))).find("truncated"), std::string::npos)
            << length;
    EXPECT_NE(refusal(write_bytes(whole.substr(0, whole.size() - 1))).find("truncated"), std::string::npos);
    EXPECT_EQ(refusal(write_bytes(whole)), "");
}

TEST_F(VdbOracle, answers_four_threads_at_once_as_it_answers_one)
{
    const VdbSurface surface = read_vdb_surface(write({fog_ball({-300, 5, -77}, 11.3)}));
    expect_same_answers_from_four_threads(*surface.oracle, 20'000);
}

TEST_F(VdbOracle, transforms_without_a_rigid_frame_are_refused)
{
    const auto sheared = fog_ball({0, 0, 0}, 5.0);
    auto matrix = openvdb::Mat4R::identity();
    matrix.setRow(1, openvdb::Vec4R(0.5, 1, 0, 0));
    sheared->setTransform(openvdb::math::Transform::createLinearTransform(matrix));
    EXPECT_NE(refusal(write({sheared})).find("sheared"), std::string::npos);

    const auto frustum = fog_ball({0, 0, 0}, 5.0);
    frustum->setTransform(openvdb::math::Transform::createFrustumTransform(
        openvdb::BBoxd(openvdb::Vec3d(0, 0, 0), openvdb::Vec3d(10, 10, 10)), 0.5, 2.0, 1.0));
    EXPECT_NE(refusal(write({frustum})).find("frustum"), std::string::npos);
}

} // namespace
} // namespace voroprobe
