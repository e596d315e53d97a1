#include "oracles/point_cloud_oracle.h"

#include <cmath>
#include <numbers>

#include "concurrent_queries.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "oracle_laws.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

using std::numbers::pi;

constexpr double kRadius = 10.0;

//! Points spread evenly over a sphere along a spiral (Fibonacci lattice).
std::vector<OrientedPoint> sphere_cloud(std::size_t count, const Point3& center = {})
{
    std::vector<OrientedPoint> cloud;
    for (std::size_t i = 0; i < count; ++i)
    {
        const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
        const double angle = static_cast<double>(i) * pi * (3.0 - std::sqrt(5.0));
        const double r = std::sqrt(1.0 - z * z);
        const Vec3 normal{r * std::cos(angle), r * std::sin(angle), z};
        cloud.push_back({center + kRadius * normal, normal});
    }
    return cloud;
}

//! Mean distance between neighbours: each point has an equal share of the area.
double spacing(std::size_t count)
{
    return kRadius * std::sqrt(4.0 * pi / static_cast<double>(count));
}

// Points of one sphere are the worst for Delaunay refinement: every ball through four of them is that sphere.
TEST(PointCloud, of_a_sphere_is_fitted_by_a_closed_surface_near_it)
{
    for (const std::size_t count : {200U, 500U, 1500U})
    {
        const TriangleMesh mesh = fit_point_cloud(sphere_cloud(count));
        const MeshTopology topology = analyze_topology(mesh);
        EXPECT_TRUE(topology.closed());
        EXPECT_TRUE(topology.manifold());
        EXPECT_TRUE(topology.oriented());
        EXPECT_EQ(topology.components, 1U);
        EXPECT_EQ(topology.euler_characteristic, 2);
        EXPECT_NEAR(enclosed_volume(mesh) / (4.0 / 3.0 * pi * kRadius * kRadius * kRadius), 1.0, 0.05);
        for (const Point3& p : mesh.vertices)
            ASSERT_NEAR(norm(p), kRadius, spacing(count));
    }
}

TEST(PointCloudOracle, tells_the_sides_of_two_spheres)
{
    std::vector<OrientedPoint> cloud = sphere_cloud(800);
    for (const OrientedPoint& point : sphere_cloud(800, {30, 0, 0}))
        cloud.push_back(point);
    const auto oracle = make_point_cloud_oracle(cloud);
    const double margin = spacing(800);
    Random random(1);
    for (int i = 0; i < 5000; ++i)
    {
        const Point3 p = random_point(random, {{-12, -12, -12}, {42, 12, 12}});
        const double beyond = std::min(norm(p), norm(p - Vec3{30, 0, 0})) - kRadius;
        if (std::abs(beyond) > margin)
        {
            ASSERT_EQ(is_inside(oracle->region(p)), beyond < 0.0) << p.x << ' ' << p.y << ' ' << p.z;
        }
    }
}

TEST(PointCloudOracle, keeps_the_laws_of_oracles)
{
    const auto oracle = make_point_cloud_oracle(sphere_cloud(500));
    expect_laws_on_random_segments(*oracle, 2, 10000);
    EXPECT_TRUE(is_inside(oracle->region({0, 0, 0})));
    EXPECT_FALSE(is_inside(oracle->region({12, 0, 0})));
    expect_same_answers_from_four_threads(*oracle, 1000);
}

TEST(PointCloud, refuses_clouds_that_surround_nothing)
{
    EXPECT_THROW(fit_point_cloud({}), InputError);
    EXPECT_THROW(fit_point_cloud(sphere_cloud(9)), InputError);
    std::vector<OrientedPoint> cloud = sphere_cloud(50);
    cloud[7].normal = {};
    EXPECT_THROW(fit_point_cloud(cloud), InputError);
    cloud = sphere_cloud(50);
    cloud[7].position.y = std::nan("");
    EXPECT_THROW(fit_point_cloud(cloud), InputError);
    for (OrientedPoint& point : cloud = sphere_cloud(50))
        point.position.z = 0.0;
    EXPECT_THROW(fit_point_cloud(cloud), InputError);
}

} // namespace
} // namespace voroprobe
