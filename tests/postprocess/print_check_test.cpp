#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "mesh/measures.h"
#include "postprocess/print_check.h"

namespace voroprobe
{
namespace
{

using sample::append;
using sample::icosphere;

//! A box with faces outward.
TriangleMesh box(const Vec3& low, const Vec3& high)
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

PrintCheck check(const TriangleMesh& mesh, const PrintOptions& options = {})
{
    return check_printable({{.name = "", .mesh = mesh}}, options);
}

TriangleMesh inside_out(TriangleMesh mesh)
{
    for (TriangleMesh::Face& face : mesh.faces)
        std::swap(face[1], face[2]);
    return mesh;
}

TEST(PrintCheck, a_plate_is_as_thick_as_it_is)
{
    const TriangleMesh plate = box({0, 0, 0}, {40, 30, 0.8});
    const PrintCheck result = check(plate, {.min_wall = 1.0});
    ASSERT_TRUE(result.thinnest_wall);
    EXPECT_NEAR(result.thinnest_wall->length, 0.8, 1e-9);
    EXPECT_GT(result.thin_area_share, 0.9);
    ASSERT_EQ(result.failures.size(), 1U);
    EXPECT_NE(result.failures[0].find("--min-wall"), std::string::npos);
    EXPECT_TRUE(check(plate, {.min_wall = 0.7}).failures.empty());
}

TEST(PrintCheck, one_thin_place_is_the_thinnest_wall_and_moves_no_share)
{
    TriangleMesh parts = box({0, 0, 0}, {40, 30, 8});
    append(parts, box({50, 0, 0}, {50.5, 0.5, 0.01}));
    const PrintCheck result = check(parts, {.min_wall = 1.0});
    EXPECT_NEAR(result.thinnest_wall->length, 0.01, 1e-9);
    EXPECT_EQ(result.failures.size(), 1U);
    EXPECT_LT(result.thin_area_share, 0.001);
    ASSERT_TRUE(result.wall_thickness);
    EXPECT_NEAR(result.wall_thickness->percent_1, 8.0, 1e-9);
    EXPECT_NEAR(result.wall_thickness->percent_5, 8.0, 1e-9);
    EXPECT_NEAR(result.wall_thickness->median, 8.0, 1e-9); // 2,400 of 3,520 mm2
    EXPECT_FALSE(check(icosphere(0, 1.0), {.samples = 0}).wall_thickness);
}

TEST(PrintCheck, a_hollow_ball_has_a_wall_and_a_trapped_cavity)
{
    TriangleMesh ball = icosphere(4, 20.0);
    append(ball, inside_out(icosphere(4, 18.0)));
    const PrintCheck result = check(ball, {.density_g_cm3 = 1.25});
    EXPECT_EQ(result.bodies, 1U);
    ASSERT_EQ(result.cavities.size(), 1U);
    EXPECT_NEAR(result.cavities[0].volume, enclosed_volume(icosphere(4, 18.0)), 1e-6);
    EXPECT_NEAR(result.thinnest_wall->length, 2.0, 0.05);
    EXPECT_NEAR(*result.weight_g, 1.25e-3 * enclosed_volume(ball), 1e-9);
    EXPECT_EQ(result.warnings.size(), 1U);
}

TEST(PrintCheck, two_boxes_have_a_gap_between_them)
{
    TriangleMesh pair = box({0, 0, 0}, {10, 10, 10});
    append(pair, box({10.3, 0, 0}, {20, 10, 10}));
    const PrintCheck result = check(pair);
    EXPECT_EQ(result.bodies, 2U);
    ASSERT_TRUE(result.narrowest_gap);
    EXPECT_NEAR(result.narrowest_gap->length, 0.3, 1e-9);
    EXPECT_NEAR(result.thinnest_wall->length, 9.7, 1e-9);
}

TEST(PrintCheck, only_what_hangs_over_is_counted)
{
    TriangleMesh table = box({0, 0, 0}, {10, 10, 20});
    append(table, box({-5, -5, 20.5}, {15, 15, 25}));
    EXPECT_NEAR(check(table).overhang_area, 400.0, 1e-9); // the plate's underside; the leg stands on the bed
}

TEST(PrintCheck, sizes_that_look_like_other_units_are_warned_of)
{
    EXPECT_NE(check(icosphere(2, 0.1)).warnings.at(0).find("metres"), std::string::npos);
    EXPECT_NE(check(icosphere(2, 3.0)).warnings.at(0).find("inches"), std::string::npos);
    EXPECT_NE(check(icosphere(2, 40000.0)).warnings.at(0).find("micrometres"), std::string::npos);
    EXPECT_TRUE(check(icosphere(2, 50.0)).warnings.empty());
}

TEST(PrintCheck, the_bed_may_be_turned_but_not_tipped)
{
    const TriangleMesh long_box = box({0, 0, 0}, {200, 90, 40});
    EXPECT_TRUE(check(long_box, {.bed = Vec3{220, 100, 50}}).fits);
    const PrintCheck turned = check(long_box, {.bed = Vec3{100, 220, 50}});
    EXPECT_TRUE(turned.fits && turned.fits_turned);
    const PrintCheck high = check(long_box, {.bed = Vec3{220, 220, 30}});
    EXPECT_FALSE(high.fits);
    EXPECT_EQ(high.failures.size(), 1U);
}

} // namespace
} // namespace voroprobe
