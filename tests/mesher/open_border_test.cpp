#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/measures.h"
#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/implicit_oracle.h"
#include "oracles/trilinear_oracle.h"
#include "random_volumes.h"
#include "self_intersections.h"
#include "surface_distance.h"
#include "volume/inventory.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

constexpr MeshingOptions kOpen{.max_facet_radius = 1.0,
                               .max_facet_distance = 0.1,
                               .floor_radius = 0.2,
                               .reach_lower_bound = 0.5,
                               .close_border = false};

//! As volumes hold it, one sample at every whole number from 0 to `last`.
template <typename Field>
std::unique_ptr<SurfaceOracle> sampled(Field field, std::size_t last)
{
    const std::size_t count = last + 1;
    return make_trilinear_oracle(
        std::make_shared<Volume>(sample_volume(field, {count, count, count}, {1, 1, 1})), 0.0);
}

double distance_to_sides(const Box3& box, const Point3& p)
{
    double least = box.diagonal();
    for (std::size_t axis = 0; axis < 3; ++axis)
        least = std::min({least, std::abs(p[axis] - box.min[axis]), std::abs(box.max[axis] - p[axis])});
    return least;
}

//! The vertices of edges on one face only.
std::vector<Point3> rim_of(const TriangleMesh& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> faces_on_edge;
    for (const TriangleMesh::Face& face : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i)
            ++faces_on_edge[std::minmax(face[i], face[(i + 1) % 3])];
    std::vector<Point3> rim;
    for (const auto& [edge, faces] : faces_on_edge)
        if (faces == 1)
        {
            rim.push_back(mesh.vertices[edge.first]);
            rim.push_back(mesh.vertices[edge.second]);
        }
    return rim;
}

void expect_sound(const TriangleMesh& mesh)
{
    const MeshTopology topology = analyze_topology(weld(mesh));
    EXPECT_TRUE(topology.manifold());
    EXPECT_TRUE(topology.oriented());
    EXPECT_EQ(topology.unused_vertices, 0U);
    EXPECT_EQ(topology.degenerate_faces, 0U);
    EXPECT_TRUE(find_self_intersections(mesh).empty());
}

void expect_rim_on_box(const TriangleMesh& mesh, const Box3& box)
{
    const std::vector<Point3> rim = rim_of(mesh);
    EXPECT_FALSE(rim.empty());
    for (const Point3& p : rim)
        EXPECT_NEAR(distance_to_sides(box, p), 0.0, 1e-9);
}

TEST(OpenBorder, leaves_two_disks_of_a_slab)
{
    const auto slab = sampled([](const Point3& p) { return 2.3 - std::abs(p.z - 4.6); }, 9);
    const TriangleMesh mesh = mesh_surface(*slab, kOpen).mesh;
    expect_sound(mesh);
    expect_rim_on_box(mesh, slab->domain());
    EXPECT_EQ(count_components(mesh), 2U);
    EXPECT_EQ(euler_characteristic(mesh), 2);
    EXPECT_NEAR(area(mesh), 2.0 * 9.0 * 9.0, 0.01);
    for (const Point3& p : mesh.vertices)
        EXPECT_NEAR(std::abs(p.z - 4.6), 2.3, 0.002);
}

TEST(OpenBorder, leaves_the_walls_of_two_bores)
{
    const double radius = 2.5;
    const auto bores = sampled(
        [&](const Point3& p)
        { return std::min(std::hypot(p.x - 4.3, p.y - 5.6), std::hypot(p.x - 11.2, p.y - 9.9)) - radius; },
        15);
    const TriangleMesh mesh = mesh_surface(*bores, kOpen).mesh;
    expect_sound(mesh);
    expect_rim_on_box(mesh, bores->domain());
    EXPECT_EQ(count_components(mesh), 2U);
    EXPECT_EQ(euler_characteristic(mesh), 0);
    EXPECT_NEAR(area(mesh), 2.0 * 2.0 * std::numbers::pi * radius * 15.0, 0.05 * area(mesh));
    const auto to_walls = [&](const Point3& p)
    { return std::min(std::hypot(p.x - 4.3, p.y - 5.6), std::hypot(p.x - 11.2, p.y - 9.9)) - radius; };
    EXPECT_LT(largest_distance_from_faces(mesh, to_walls, 3), 0.3);
}

TEST(OpenBorder, leaves_an_octant_of_a_sphere_in_the_corner_of_the_box)
{
    const double radius = 8.0;
    const ImplicitOracle ball([&](const Point3& p) { return radius - norm(p); }, {{0, 0, 0}, {10, 10, 10}},
                              1.0, 1e-3);
    const TriangleMesh mesh = mesh_surface(ball, kOpen).mesh;
    expect_sound(mesh);
    expect_rim_on_box(mesh, ball.domain());
    EXPECT_EQ(count_components(mesh), 1U);
    EXPECT_EQ(euler_characteristic(mesh), 1);
    EXPECT_NEAR(area(mesh), 0.5 * std::numbers::pi * radius * radius, 1.0);
    const auto to_sphere = [&](const Point3& p) { return norm(p) - radius; };
    EXPECT_LT(largest_distance_from_faces(mesh, to_sphere, 3), 0.2);
    Random random(1);
    std::vector<Point3> points;
    while (points.size() < 1000)
    {
        const Vec3 way{random.uniform(), random.uniform(), random.uniform()};
        points.push_back(radius * normalized(way));
    }
    EXPECT_LT(largest_distance_from_points(points, mesh), 0.2) << "nothing of the sphere is lost";
}

//! A slanted plane; below it is inside.
class Plane final : public ScalarField
{
public:
    [[nodiscard]] double value(const Point3& p) const override { return 1.0 - p.z + 0.1 * p.x; }
    [[nodiscard]] bool ends_tell_all(const Segment3&, const EndValues&) const override { return true; }
    [[nodiscard]] BoxSide side_of(const Box3&) const override { return BoxSide::kUnknown; }
};

TEST(OpenBorder, leaves_a_disk_of_a_plane_through_a_ball)
{
    const double radius = 5.0;
    const ImplicitOracle cut(std::make_shared<Plane>(), ImplicitDomain({0, 0, 0}, radius), 1e-3);
    const TriangleMesh mesh = mesh_surface(cut, kOpen).mesh;
    expect_sound(mesh);
    EXPECT_EQ(count_components(mesh), 1U);
    EXPECT_EQ(euler_characteristic(mesh), 1);
    for (const Point3& p : rim_of(mesh))
        EXPECT_NEAR(norm(p), radius, 1e-9);
    EXPECT_NEAR(area(mesh), std::numbers::pi * (radius * radius - 1.0 / 1.01), 1.0);
}

//! Points of the surface itself, not of its caps.
std::vector<Point3> points_off_border(const SurfaceOracle& oracle, std::size_t count, Random& random)
{
    std::vector<Point3> points = sample_surface(oracle, count, random);
    std::erase_if(points, [&](const Point3& p) { return distance_to_sides(oracle.domain(), p) < 1e-9; });
    return points;
}

//! An upper bound: to the nearest of some points, and of the crossings along the axes, which meet specks too.
double distance_to_surface(const Point3& p, const SurfaceOracle& oracle, const std::vector<Point3>& points)
{
    double squared = std::numeric_limits<double>::infinity();
    for (const Point3& q : points)
        squared = std::min(squared, squared_distance(p, q));
    std::vector<Crossing> crossings;
    for (const Vec3& axis : {Vec3{2, 0, 0}, Vec3{0, 2, 0}, Vec3{0, 0, 2}})
    {
        oracle.find_crossings({p - axis, p + axis}, crossings);
        for (const Crossing& crossing : crossings)
            if (!crossing.on_border)
                squared = std::min(squared, squared_distance(p, crossing.point));
    }
    return std::sqrt(squared);
}

TEST(OpenBorder, leaves_nothing_of_the_caps_and_loses_nothing_of_the_surface)
{
    for (const VolumeKind kind : {VolumeKind::kThroughBorder, VolumeKind::kSmoothNoise})
    {
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
        {
            const RandomVolume random = make_random_volume(kind, seed);
            SCOPED_TRACE(random.name);
            const LevelledVolume levelled = level_volume(random.volume, random.isovalue);
            const auto oracle = make_trilinear_oracle(
                levelled, std::make_shared<const Inventory>(*make_height_field(levelled)));
            const TriangleMesh mesh = mesh_surface(*oracle, kOpen).mesh;
            expect_sound(mesh);
            Random lines(seed);
            const std::vector<Point3> points = points_off_border(*oracle, 10000, lines);
            const auto to_surface = [&](const Point3& p) { return distance_to_surface(p, *oracle, points); };
            EXPECT_LT(largest_distance_from_faces(mesh, to_surface, 3), kOpen.max_facet_radius);
            EXPECT_LT(largest_distance_from_points(points, mesh), kOpen.max_facet_radius);
        }
    }
}

TEST(OpenBorder, leaves_a_manifold_with_a_rim_also_where_samples_are_noise)
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
        const RandomVolume random = make_random_volume(VolumeKind::kWhiteNoise, seed);
        SCOPED_TRACE(random.name);
        const auto oracle = make_trilinear_oracle(random.volume, random.isovalue);
        const TriangleMesh mesh = mesh_surface(*oracle, kOpen).mesh;
        expect_sound(mesh);
        EXPECT_FALSE(rim_of(mesh).empty());
    }
}

} // namespace
} // namespace voroprobe
