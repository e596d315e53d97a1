#include "compare/contestant_list.h"

#include <numbers>

#include <gtest/gtest.h>

#include "compare/measurement.h"
#include "compared_phantom.h"
#include "mesh/measures.h"
#include "mesh/topology.h"

namespace voroprobe
{

namespace
{

const Point3 kCenter{12.1, 12.2, 12.3};
constexpr double kRadius = 8.0;
constexpr double kBallVolume = 4.0 / 3.0 * std::numbers::pi * kRadius * kRadius * kRadius;

//! Meshes this coarse lie inside the ball by a few percent; smoothed ones shrink more.
constexpr double kVolumeTolerance = 0.1;

TriangleMesh mesh_by(const ContestantEntry& entry, MeshingTask task)
{
    task.target_vertices = 300;
    task.target_edge_length = 2.5;
    const auto contestant = entry.make(task);
    StageClock clock;
    contestant->mesh(clock);
    EXPECT_FALSE(clock.end().empty()) << entry.name;
    return weld(contestant->result());
}

class EveryContestant : public testing::TestWithParam<std::size_t>
{
protected:
    ContestantEntry entry_ = all_contestants().at(GetParam());
};

TEST_P(EveryContestant, meshes_a_sphere_closed_and_outward)
{
    const ComparedPhantom phantom = compared_phantom(sphere_phantom(kCenter, kRadius), {25, 25, 25});
    const TriangleMesh mesh = mesh_by(entry_, phantom.task);
    EXPECT_TRUE(is_closed_manifold(mesh)) << entry_.name;
    EXPECT_EQ(euler_characteristic(mesh), 2) << entry_.name;
    EXPECT_NEAR(enclosed_volume(mesh), kBallVolume, kVolumeTolerance * kBallVolume) << entry_.name;
}

TEST_P(EveryContestant, takes_what_lies_below_the_isovalue_where_that_is_asked)
{
    const LevelFunction sphere = sphere_phantom(kCenter, kRadius);
    ComparedPhantom phantom = compared_phantom([&](const Point3& p) { return -sphere(p); }, {25, 25, 25});
    phantom.task.inside = InsideIs::kBelow;
    const TriangleMesh mesh = mesh_by(entry_, phantom.task);
    EXPECT_NEAR(enclosed_volume(mesh), kBallVolume, kVolumeTolerance * kBallVolume) << entry_.name;
}

//! Half of the ball lies beyond the border: its cap is part of the surface.
TEST_P(EveryContestant, closes_the_object_on_the_border_of_the_volume)
{
    const Point3 center{12.1, 12.2, 0.0};
    const ComparedPhantom phantom = compared_phantom(sphere_phantom(center, 8.0), {25, 25, 13});
    const TriangleMesh mesh = mesh_by(entry_, phantom.task);
    EXPECT_TRUE(analyze_topology(mesh).closed()) << entry_.name;
    EXPECT_NEAR(enclosed_volume(mesh), 0.5 * kBallVolume, kVolumeTolerance * kBallVolume) << entry_.name;
    EXPECT_GE(bounding_box(mesh).min.z, -0.5) << entry_.name;
}

INSTANTIATE_TEST_SUITE_P(All, EveryContestant, testing::Range<std::size_t>(0, all_contestants().size()),
                         [](const auto& instance) { return all_contestants().at(instance.param).name; });

TEST(Contestants, marching_cubes_caps_lie_on_the_border_exactly)
{
    const ComparedPhantom phantom = compared_phantom(sphere_phantom({12.1, 12.2, 0.0}, 8.0), {25, 25, 13});
    const auto contestant = make_marching_cubes(phantom.task);
    StageClock clock;
    contestant->mesh(clock);
    const TriangleMesh mesh = contestant->result();
    EXPECT_EQ(bounding_box(mesh).min.z, 0.0);
    const TwoSidedDistance distance = measure_distance(mesh, phantom.reference, {.mesh_samples = 2000});
    EXPECT_LT(distance.max, 0.1); // of a padded cap it would be up to a voxel
}

//! Around the corner of a volume vertices of three caps fall together.
TEST(Contestants, marching_cubes_are_closed_and_manifold_around_a_corner_of_the_volume)
{
    const ComparedPhantom phantom = compared_phantom(sphere_phantom({0.1, 0.2, 0.3}, 8.0), {13, 13, 13});
    for (const auto& make : {make_marching_cubes, make_openvdb})
    {
        const auto contestant = make(phantom.task);
        StageClock clock;
        contestant->mesh(clock);
        const TriangleMesh mesh = contestant->result();
        EXPECT_TRUE(is_closed_manifold(mesh));
        EXPECT_EQ(euler_characteristic(mesh), 2);
        EXPECT_NEAR(enclosed_volume(mesh), kBallVolume / 8.0, 0.15 * kBallVolume / 8.0);
    }
}

TEST(Contestants, make_mesh_3_without_its_scan_misses_small_parts_and_ours_does_not)
{
    std::vector<LevelFunction> shapes{sphere_phantom({20, 20, 20}, 14.0)};
    for (const double x : {3.1, 36.9})
        for (const double y : {3.2, 36.8})
            shapes.push_back(sphere_phantom({x, y, 3.1}, 1.4));
    const ComparedPhantom phantom = compared_phantom(union_of(shapes), {41, 41, 41});
    const auto pieces = [&](const std::unique_ptr<Contestant>& contestant)
    {
        StageClock clock;
        contestant->mesh(clock);
        return count_components(contestant->result());
    };
    EXPECT_EQ(pieces(make_voroprobe(phantom.task)), 5U);
    EXPECT_LT(pieces(make_mesh_3(phantom.task, Mesh3Seeding::kDefault)), 5U);
}

TEST(Contestants, a_coarser_task_multiplies_lengths_and_divides_counts)
{
    MeshingTask task = compared_phantom(sphere_phantom(kCenter, kRadius), {25, 25, 25}).task;
    task.target_vertices = 400;
    task.target_edge_length = 1.5;
    EXPECT_EQ(coarser(task, Knob::kCriteria, 2.0).max_facet_distance, 0.6);
    EXPECT_EQ(coarser(task, Knob::kCriteria, 2.0).floor_radius,
              task.floor_radius); // or surfaces would be lost
    EXPECT_EQ(coarser(task, Knob::kCriteria, 0.5).floor_radius, 0.125);
    EXPECT_EQ(coarser(task, Knob::kTargetVertices, 2.0).target_vertices, 100U);
    EXPECT_EQ(coarser(task, Knob::kTargetEdge, 2.0).target_edge_length, 3.0);
    EXPECT_EQ(coarser(task, Knob::kNone, 2.0).max_facet_radius, task.max_facet_radius);
}

} // namespace

} // namespace voroprobe
