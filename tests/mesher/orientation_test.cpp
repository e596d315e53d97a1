// The mesh of a scan does not depend on how the file stores it.

#include "mesher/seeded_mesher.h"

#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../volume/stored_orders.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "oracles/trilinear_oracle.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

constexpr double kSamePlace = 1e-4; // mm
const Vec3 kSpacing{0.5, 0.6, 0.75};
const Point3 kOrigin{-31.5, 12.25, 103.0};

//! A shell that is like none of its mirror images and turns, on its canonical grid.
const Volume& canonical()
{
    static const Volume kVolume = sample_volume(
        [](const Point3& p)
        {
            const double ball = 3.5 - distance(p, {5.0, 5.2, 5.1});
            const double bump = 1.5 - distance(p, {7.9, 6.8, 4.6});
            const double cavity = distance(p, {4.1, 5.5, 5.8}) - 1.4;
            return std::min(std::max(ball, bump), cavity);
        },
        {21, 18, 14}, kSpacing);
    return kVolume;
}

//! The samples as a file stores them in `order`, its axes turned by `rotation` about the world's origin.
Volume stored(const StoredOrder& order, const Matrix3& rotation)
{
    const Volume& volume = canonical();
    StoredLattice lattice{.size = {}, .origin = kOrigin};
    Vec3 first{0, 0, 0}; // canonical index of the first stored sample
    for (std::size_t s = 0; s < 3; ++s)
    {
        const std::size_t a = order.axis[s];
        lattice.size[s] = volume.geometry.size[a];
        lattice.spacing[s] = kSpacing[a];
        lattice.direction.column[s] = (order.reversed[s] ? -1.0 : 1.0) * rotation.column[a];
        lattice.start[s] = order.start[s];
        if (order.reversed[s])
            first[a] = static_cast<double>(volume.geometry.size[a] - 1);
    }
    lattice.origin =
        rotation * (kOrigin + Vec3{first.x * kSpacing.x, first.y * kSpacing.y, first.z * kSpacing.z});
    for (std::size_t s = 0; s < 3; ++s)
        lattice.origin -=
            static_cast<double>(order.start[s]) * lattice.spacing[s] * lattice.direction.column[s];

    std::vector<float> samples;
    for (std::size_t w = 0; w < lattice.size[2]; ++w)
        for (std::size_t v = 0; v < lattice.size[1]; ++v)
            for (std::size_t u = 0; u < lattice.size[0]; ++u)
            {
                const std::array at_stored{u, v, w};
                std::array<std::size_t, 3> at{};
                for (std::size_t s = 0; s < 3; ++s)
                    at[order.axis[s]] = order.reversed[s] ? lattice.size[s] - 1 - at_stored[s] : at_stored[s];
                samples.push_back(static_cast<float>(volume.at(at[0], at[1], at[2])));
            }
    return make_volume(lattice, std::move(samples));
}

//! The mesh of a stored volume in the world frame.
TriangleMesh world_mesh(const Volume& volume)
{
    const auto oracle = make_trilinear_oracle(std::make_shared<Volume>(volume), 0.0);
    TriangleMesh mesh = mesh_surface(*oracle, {.max_facet_radius = 0.8,
                                               .max_facet_distance = 0.05,
                                               .floor_radius = 0.12,
                                               .reach_lower_bound = 0.3})
                            .mesh;
    transform(mesh, volume.geometry.world_from_grid);
    return mesh;
}

void expect_same(const TriangleMesh& found, const TriangleMesh& expected)
{
    ASSERT_EQ(found.faces, expected.faces);
    ASSERT_EQ(found.vertices.size(), expected.vertices.size());
    for (std::size_t v = 0; v < found.vertices.size(); ++v)
        ASSERT_LT(distance(found.vertices[v], expected.vertices[v]), kSamePlace) << "vertex " << v;
}

struct Orientation
{
    StoredOrder order;
    Matrix3 rotation{};

    friend void PrintTo(const Orientation& orientation, std::ostream* out) { *out << orientation.order.name; }
};

class EveryOrientation : public testing::TestWithParam<Orientation>
{
};

TEST_P(EveryOrientation, gives_the_same_world_mesh)
{
    const auto& [order, rotation] = GetParam();
    const TriangleMesh reference = world_mesh(stored({"identity", {0, 1, 2}, {false, false, false}}, {}));
    ASSERT_EQ(count_components(reference), 2U);

    TriangleMesh mesh = world_mesh(stored(order, rotation));
    EXPECT_TRUE(is_closed_manifold(mesh));
    EXPECT_GT(enclosed_volume(mesh), 0.0);
    transform(mesh, {inverse(rotation), {0, 0, 0}}); // undoes the turn of oblique volumes
    expect_same(mesh, reference);
}

INSTANTIATE_TEST_SUITE_P(
    Stored, EveryOrientation,
    testing::Values(Orientation{{"identity", {0, 1, 2}, {false, false, false}}},
                    Orientation{{"two_flips", {0, 1, 2}, {true, true, false}}},
                    Orientation{{"permuted", {2, 0, 1}, {false, false, false}}},
                    Orientation{{"left_handed_flip", {0, 1, 2}, {false, false, true}}},
                    Orientation{{"left_handed_swap", {1, 0, 2}, {false, false, false}}},
                    Orientation{{"oblique", {0, 1, 2}, {false, false, false}},
                                rotation_about({1, 0, 0}, 16.5)},
                    Orientation{{"oblique_permuted_flipped", {1, 2, 0}, {true, false, true}},
                                rotation_about({1, 2, 3}, -20.0)},
                    Orientation{{"region_start", {0, 2, 1}, {true, false, false}, {4, -9, 100}}}),
    [](const auto& stored_case) { return std::string(stored_case.param.order.name); });

TEST(OrientedVolume, the_mesh_stands_where_the_shape_stands_in_the_world)
{
    const TriangleMesh mesh = world_mesh(stored({"", {2, 0, 1}, {true, false, false}, {3, 5, 7}}, {}));
    const Box3 box = bounding_box(mesh);
    // The ball's far sides, to within the distance bound and the interpolation error.
    EXPECT_NEAR(box.min.x, kOrigin.x + 1.5, 0.1);
    EXPECT_NEAR(box.max.x, kOrigin.x + 9.4, 0.1); // the bump
    EXPECT_NEAR(box.min.y, kOrigin.y + 1.7, 0.1);
    EXPECT_NEAR(box.max.z, kOrigin.z + 8.6, 0.1);
}

} // namespace
} // namespace voroprobe
