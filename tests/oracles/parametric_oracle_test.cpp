#include "oracles/parametric_oracle.h"

#include <cmath>
#include <numbers>

#include "mesh/measures.h"
#include "mesh/topology.h"
#include "oracle_laws.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

using std::numbers::pi;

constexpr double kMajor = 2.0;
constexpr double kMinor = 0.7;

Point3 torus(double u, double v)
{
    const double a = 2.0 * pi * u;
    const double b = 2.0 * pi * v;
    const double r = kMajor + kMinor * std::cos(b);
    return {r * std::cos(a), r * std::sin(a), kMinor * std::sin(b)};
}

Point3 sphere(double u, double v)
{
    const double a = 2.0 * pi * u;
    const double b = pi * v;
    return {std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b)};
}

double distance_from_torus(const Point3& p)
{
    return std::abs(std::hypot(std::hypot(p.x, p.y) - kMajor, p.z) - kMinor);
}

const ParametricSurface kTorus{.point = torus, .joined_in_u = true, .joined_in_v = true};
const ParametricSurface kSphere{.point = sphere, .joined_in_u = true};

TEST(Parametric, a_torus_joins_both_pairs_of_sides)
{
    const TriangleMesh mesh = tessellate(kTorus, 0.01);
    EXPECT_TRUE(is_closed_manifold(mesh));
    EXPECT_EQ(euler_characteristic(mesh), 0);
    EXPECT_EQ(count_components(mesh), 1U);
    EXPECT_NEAR(std::abs(enclosed_volume(mesh)), 2.0 * pi * pi * kMajor * kMinor * kMinor, 0.3);
}

TEST(Parametric, a_sphere_has_poles_of_one_vertex)
{
    const TriangleMesh mesh = tessellate(kSphere, 0.002);
    EXPECT_TRUE(is_closed_manifold(mesh));
    EXPECT_EQ(euler_characteristic(mesh), 2);
    EXPECT_NEAR(std::abs(enclosed_volume(mesh)), 4.0 / 3.0 * pi, 0.02);
}

// A triangle whose edges stray from the surface by t strays by less than 4 t within: its circle is that of
// its longest edge at most.
TEST(Parametric, the_tolerance_bounds_the_distance_from_the_surface)
{
    for (const double tolerance : {0.05, 0.005, 0.0005})
    {
        const TriangleMesh mesh = tessellate(kTorus, tolerance);
        double farthest = 0.0;
        for (const TriangleMesh::Face& face : mesh.faces)
        {
            const Point3 center = (mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3.0;
            farthest = std::max(farthest, distance_from_torus(center));
        }
        EXPECT_LE(farthest, 4.0 * tolerance);
        EXPECT_GE(farthest, 0.02 * tolerance) << "far finer than was asked";
    }
}

TEST(ParametricOracle, its_crossings_lie_on_the_surface_and_its_sides_are_those_of_a_torus)
{
    constexpr double kTolerance = 0.002;
    const auto oracle = make_parametric_oracle(kTorus, kTolerance);
    Random random(1);
    std::vector<Crossing> crossings;
    for (int i = 0; i < 20000; ++i)
    {
        const Segment3 segment = random_segment(random, {{-3, -3, -1}, {3, 3, 1}});
        oracle->find_crossings(segment, crossings);
        for (const Crossing& crossing : crossings)
            ASSERT_LE(distance_from_torus(crossing.point), 4.0 * kTolerance);
        const Point3& p = segment.source;
        if (distance_from_torus(p) > 4.0 * kTolerance)
        {
            ASSERT_EQ(is_inside(oracle->region(p)), std::hypot(std::hypot(p.x, p.y) - kMajor, p.z) < kMinor);
        }
    }
    expect_laws_on_random_segments(*oracle, 2, 5000);
}

TEST(ParametricOracle, refuses_surfaces_that_bound_nothing)
{
    const ParametricSurface cylinder{.point =
                                         [](double u, double v) {
                                             return Point3{std::cos(2 * pi * u), std::sin(2 * pi * u), v};
                                         },
                                     .joined_in_u = true};
    EXPECT_THROW(make_parametric_oracle(cylinder, 0.01), InputError);
    const ParametricSurface crossing{.point =
                                         [](double u, double v) {
                                             return torus(u, v) + Vec3{2.5 * std::cos(4 * pi * u), 0, 0};
                                         },
                                     .joined_in_u = true,
                                     .joined_in_v = true};
    EXPECT_THROW(make_parametric_oracle(crossing, 0.05), InputError);
}

TEST(Parametric, refuses_arguments_outside_their_range)
{
    EXPECT_THROW(tessellate({}, 0.1), UsageError);
    EXPECT_THROW(tessellate(kTorus, 0.0), UsageError);
    EXPECT_THROW(tessellate(kTorus, std::nan("")), UsageError);
    EXPECT_THROW(tessellate(kTorus, 1e-9), UsageError);
    const ParametricSurface undefined{.point = [](double u, double v) {
        return Point3{std::sqrt(u - 0.5), v, 0};
    }};
    EXPECT_THROW(tessellate(undefined, 0.1), UsageError);
}

} // namespace
} // namespace voroprobe
