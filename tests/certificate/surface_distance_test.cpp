#include "certificate/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "certificate/mesh_distance.h"
#include "oracles/implicit_oracle.h"
#include "oracles/sphere_union_oracle.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

//! How far the middle of an edge of the mesh of a sphere lies below it, at most.
double sagitta(double edge, double radius)
{
    return radius - std::sqrt(radius * radius - 0.25 * edge * edge);
}

TEST(SurfaceDistance, of_a_sphere_to_a_smaller_one_is_the_difference_of_the_radii)
{
    const TriangleMesh mesh = sample::icosphere(5, 9.5);
    const SphereUnionOracle oracle({{{0, 0, 0}, 10.0}});
    const double deepest = sagitta(0.5, 9.5) * 4.0 / 3.0; // faces are deeper in their middles than edges
    const SurfaceDistance found = surface_distance(mesh, oracle);

    EXPECT_GE(found.from_mesh.max, 0.5 - 1e-9);
    EXPECT_LE(found.from_mesh.max, 0.5 + deepest);
    EXPECT_NEAR(found.from_mesh.mean, 0.5, deepest);
    EXPECT_GE(found.from_surface.max, 0.5 - 1e-9);
    EXPECT_LE(found.from_surface.max, 0.5 + deepest);
    EXPECT_NEAR(found.from_surface.root_mean_square, 0.5, deepest);
    EXPECT_NEAR(found.from_surface.percentile_95, 0.5, deepest);
    EXPECT_NEAR(norm(found.from_surface.max_at), 10.0, 1e-9);
    EXPECT_EQ(found.from_mesh.samples, 20000U);
}

TEST(SurfaceDistance, of_a_mesh_with_its_vertices_on_the_surface_is_small_and_not_zero)
{
    const TriangleMesh mesh = sample::icosphere(4, 10.0);
    const SphereUnionOracle oracle({{{0, 0, 0}, 10.0}});
    const SurfaceDistance found = surface_distance(mesh, oracle);
    const double deepest = 4.0 / 3.0 * sagitta(1.0, 10.0);
    EXPECT_LE(found.max(), deepest);
    EXPECT_GE(found.max(), 0.2 * deepest);
}

TEST(SurfaceDistance, from_the_mesh_is_an_upper_bound_within_a_percent_on_a_torus)
{
    const auto torus_value = [](const Point3& p, double minor)
    {
        const double r = std::hypot(p.x, p.y) - 6.0;
        return minor - std::hypot(r, p.z);
    };
    const ImplicitOracle oracle([&](const Point3& p) { return torus_value(p, 2.0); },
                                {{-9, -9, -3}, {9, 9, 3}}, 1.0, 1e-3);
    const TriangleMesh mesh = sample::torus(96, 48, 6.0, 1.7);
    const SurfaceDistance found =
        surface_distance(mesh, oracle, {.mesh_samples = 4000, .surface_samples = 4000});

    EXPECT_GE(found.from_mesh.max, 0.3 - 1e-9);
    EXPECT_LE(found.from_mesh.max, 0.3 + 0.02);
    EXPECT_NEAR(found.from_mesh.mean, 0.3, 0.01);
    EXPECT_NEAR(found.from_surface.mean, 0.3, 0.01);
}

TEST(SurfaceDistance, a_missing_piece_shows_from_the_surface_only)
{
    const SphereUnionOracle oracle({{{0, 0, 0}, 5.0}, {{20, 0, 0}, 2.0}});
    const SurfaceDistance found = surface_distance(sample::icosphere(4, 5.0), oracle);
    EXPECT_LT(found.from_mesh.max, 0.05);
    EXPECT_GT(found.from_surface.max, 16.5) << "the far side of the second sphere is 17 away";
    EXPECT_LE(found.from_surface.max, 17.1);
    EXPECT_GT(found.from_surface.max_at.x, 20.0);
}

TEST(SurfaceDistance, a_piece_that_is_too_much_shows_from_the_mesh_only)
{
    TriangleMesh mesh = sample::icosphere(4, 5.0);
    sample::append(mesh, sample::icosphere(2, 1.0), {12, 0, 0});
    const SphereUnionOracle oracle({{{0, 0, 0}, 5.0}});
    const SurfaceDistance found = surface_distance(mesh, oracle);
    EXPECT_NEAR(found.from_mesh.max, 8.0, 0.05) << "its farthest point, beyond the domain";
    EXPECT_LT(found.from_surface.max, 0.05);
}

TEST(SurfaceDistance, finds_a_speck_in_a_large_box_when_given_a_point_of_it)
{
    const SphereUnionOracle oracle({{{0, 0, 0}, 5.0}, {{40, 0, 0}, 0.001}}, 30.0);
    const std::vector<Point3> speck{{40.001, 0, 0}};
    const TriangleMesh mesh = sample::icosphere(3, 5.0);
    EXPECT_NEAR(surface_distance(mesh, oracle, {.surface_samples = 100}, speck).from_surface.max, 35.0, 0.1);
}

TEST(SurfaceDistance, is_the_same_every_time_for_the_same_seed)
{
    const SphereUnionOracle oracle({{{0, 0, 0}, 10.0}});
    const TriangleMesh mesh = sample::icosphere(3, 9.9);
    const SamplingOptions options{.mesh_samples = 2000, .surface_samples = 2000, .seed = 7};
    const SurfaceDistance a = surface_distance(mesh, oracle, options);
    const SurfaceDistance b = surface_distance(mesh, oracle, options);
    EXPECT_EQ(a.from_mesh.max, b.from_mesh.max);
    EXPECT_EQ(a.from_surface.max, b.from_surface.max);
    EXPECT_EQ(a.from_mesh.mean, b.from_mesh.mean);
    EXPECT_EQ(a.from_surface.mean, b.from_surface.mean);
    EXPECT_EQ(sample_surface(oracle, options), sample_surface(oracle, options));
}

TEST(SurfaceDistance, leaves_out_caps_where_the_border_is_open)
{
    // Half a ball: the plane x = 0 is the border of the domain.
    const ImplicitOracle oracle([](const Point3& p) { return 4.0 - norm(p); }, {{0, -5, -5}, {5, 5, 5}}, 1.0,
                                1e-3);
    SamplingOptions options{.surface_samples = 2000};
    const auto on_cap = [&]
    {
        const auto points = sample_surface(oracle, options);
        return std::any_of(points.begin(), points.end(),
                           [](const Point3& p) { return p.x == 0.0 && norm(p) < 3.9; });
    };
    EXPECT_TRUE(on_cap());
    options.caps = BorderCaps::kLeftOut;
    EXPECT_FALSE(on_cap());
}

TEST(SampleSurface, spreads_points_over_a_sphere_within_the_bounds_it_states)
{
    const SphereUnionOracle oracle({{{0, 0, 0}, 10.0}});
    const auto points = sample_surface(oracle, {.surface_samples = 10000});
    ASSERT_GE(points.size(), 5000U);
    ASSERT_LE(points.size(), 10000U);
    const double cap_height = 0.4; // of the area at each of the six poles: a fiftieth of the sphere
    const double expected_share = cap_height / 20.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const auto in_cap = std::count_if(points.begin(), points.end(),
                                          [&](const Point3& p) { return p[axis] > 10.0 - cap_height; });
        const double share = static_cast<double>(in_cap) / static_cast<double>(points.size());
        EXPECT_GT(share, expected_share / 1.8);
        EXPECT_LT(share, expected_share * 1.4);
    }
}

TEST(MeshDistance, is_that_to_the_nearest_corner_side_or_face)
{
    const MeshDistance distance_to({.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, .faces = {{0, 1, 2}}});
    EXPECT_DOUBLE_EQ(distance_to({0.5, 0.5, 3.0}), 3.0);
    EXPECT_DOUBLE_EQ(distance_to({-3.0, -4.0, 0.0}), 5.0);
    EXPECT_DOUBLE_EQ(distance_to({1.0, -1.0, 0.0}), 1.0);
    EXPECT_DOUBLE_EQ(distance_to({2.0, 2.0, 0.0}), std::numbers::sqrt2);
}

TEST(MeshDistance, passes_over_flat_faces_and_refuses_a_mesh_of_them_alone)
{
    TriangleMesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, .faces = {{0, 1, 2}}};
    EXPECT_THROW(MeshDistance{mesh}, UsageError);
    mesh.vertices.push_back({0, 2, 0});
    mesh.faces.push_back({0, 1, 3});
    EXPECT_DOUBLE_EQ(MeshDistance{mesh}({0, 0, 1}), 1.0);
}

} // namespace
} // namespace voroprobe
