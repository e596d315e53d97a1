#include "labels/interface_meshing.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "certificate/self_intersections.h"
#include "labels/joint_meshing.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "random_labels.h"

namespace voroprobe
{
namespace
{

const Vec3 kUnit{1, 1, 1};

const MeshingOptions kCriteria{
    .max_facet_radius = 2.0, .max_facet_distance = 0.3, .floor_radius = 0.25, .reach_lower_bound = 1.0};

//! A ball of two halves, labels 1 and 2, in a shell of label 3 on one side.
Volume halved_ball()
{
    const std::array<std::size_t, 3> size{24, 24, 24};
    std::vector<std::uint8_t> samples;
    for (int k = 0; k < 24; ++k)
        for (int j = 0; j < 24; ++j)
            for (int i = 0; i < 24; ++i)
            {
                const double radius = distance({1.0 * i, 1.0 * j, 1.0 * k}, {12, 12, 12});
                samples.push_back(radius <= 6.5 ? (i < 12 ? 1 : 2) : radius <= 9.5 && k > 12 ? 3 : 0);
            }
    return make_volume({.size = size, .spacing = kUnit, .direction = {}, .origin = {}}, std::move(samples));
}

std::vector<std::uint32_t> all_labels(const LabelSurvey& survey)
{
    std::vector<std::uint32_t> places(survey.labels().size());
    for (std::uint32_t i = 0; i < places.size(); ++i)
        places[i] = i;
    return places;
}

std::map<std::uint32_t, LabelMesh> mesh_jointly(const LabelSurvey& survey)
{
    std::map<std::uint32_t, LabelMesh> meshes;
    mesh_labels_jointly(survey, all_labels(survey), kUnit, kCriteria, nullptr,
                        [&](LabelMesh mesh) { meshes.emplace(mesh.label, std::move(mesh)); });
    return meshes;
}

using Corners = std::array<std::array<double, 3>, 3>;

//! A face by the places of its corners, whichever way it winds.
Corners corners_of(const TriangleMesh& mesh, const TriangleMesh::Face& face)
{
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = {mesh.corner(face, i).x, mesh.corner(face, i).y, mesh.corner(face, i).z};
    std::sort(corners.begin(), corners.end());
    return corners;
}

TEST(LabelPartition, gives_voxels_their_own_label_and_has_none_beyond_the_volume)
{
    const Volume volume = random_labels({14, 12, 13}, 4, 3);
    const LabelSurvey survey(volume);
    const LabelPartition partition(survey, all_labels(survey), kUnit);
    std::size_t others = 0;
    for (int k = 0; k < 13; ++k)
        for (int j = 0; j < 12; ++j)
            for (int i = 0; i < 14; ++i)
            {
                const PartitionLabel label = partition.label({1.0 * i, 1.0 * j, 1.0 * k});
                const LabelValue value = label == 0 ? 0 : survey.labels()[label - 1].value;
                others +=
                    value != std::lround(volume.at(static_cast<std::size_t>(i), static_cast<std::size_t>(j),
                                                   static_cast<std::size_t>(k)))
                        ? 1
                        : 0;
            }
    EXPECT_LE(others, partition.voxels_overruled() + 2); // each round of strengthening may overrule the next
    EXPECT_LE(others, 20U);
    EXPECT_EQ(partition.label({-2.5, 3, 3}), 0U);
    EXPECT_EQ(partition.label({3, 3, 1e9}), 0U);
}

TEST(LabelPartition, finds_every_change_of_label_that_fine_steps_find)
{
    const Volume volume = halved_ball();
    const LabelSurvey survey(volume);
    const LabelPartition partition(survey, all_labels(survey), kUnit);
    std::vector<LabelPartition::Change> changes;
    for (int n = 0; n < 40; ++n)
    {
        const Segment3 segment{{-5.0, 3.0 + 0.4 * n, 20.0 - 0.3 * n}, {30.0, 20.0 - 0.37 * n, 4.0 + 0.4 * n}};
        partition.find_changes(segment, changes);
        std::size_t found = 0;
        PartitionLabel before = 0;
        constexpr int kSteps = 4000;
        for (int s = 0; s <= kSteps; ++s)
        {
            const double t = static_cast<double>(s) / kSteps;
            const PartitionLabel here =
                partition.label(segment.source + t * (segment.target - segment.source));
            found += here != before ? 1 : 0;
            before = here;
        }
        EXPECT_EQ(changes.size(), found) << n;
    }
}

TEST(InterfaceMeshing, each_label_is_closed_and_faces_outward)
{
    const auto meshes = mesh_jointly(LabelSurvey(halved_ball()));
    ASSERT_EQ(meshes.size(), 3U);
    for (const auto& [place, label] : meshes)
    {
        EXPECT_TRUE(label.complete());
        EXPECT_EQ(analyze_topology(label.mesh).boundary_edges, 0U);
        EXPECT_TRUE(analyze_topology(label.mesh).oriented());
        EXPECT_EQ(count_components(label.mesh), 1U);
        EXPECT_TRUE(self_intersections(label.mesh).empty());
        EXPECT_NEAR(label.mesh_volume, label.voxel_volume, 0.1 * label.voxel_volume);
    }
}

TEST(InterfaceMeshing, neighbours_have_the_same_triangles_where_they_touch_and_do_not_overlap)
{
    const auto meshes = mesh_jointly(LabelSurvey(halved_ball()));
    std::map<Corners, std::size_t> owners;
    for (const auto& [place, label] : meshes)
        for (const TriangleMesh::Face& face : label.mesh.faces)
            ++owners[corners_of(label.mesh, face)];
    std::size_t shared = 0;
    TriangleMesh all;
    for (const auto& [corners, count] : owners)
    {
        EXPECT_LE(count, 2U);
        shared += count == 2 ? 1 : 0;
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        for (const auto& [x, y, z] : corners)
            all.vertices.push_back({x, y, z});
        all.faces.push_back({first, first + 1, first + 2});
    }
    EXPECT_GT(shared, 50U);
    EXPECT_TRUE(self_intersections(weld(all)).empty()); // no two surfaces cross: no overlap
}

TEST(InterfaceMeshing, random_label_maps_give_closed_meshes_and_list_what_is_not_there)
{
    for (std::uint64_t seed = 0; seed < 3; ++seed)
    {
        const LabelSurvey survey(random_labels({16, 14, 13}, 4, seed));
        for (const auto& [place, label] : mesh_jointly(survey))
        {
            EXPECT_TRUE(label.broken_promises.empty());
            EXPECT_EQ(analyze_topology(label.mesh).boundary_edges, 0U);
            EXPECT_EQ(label.parts_meshed + label.faults.size(), survey.labels()[place].parts.size());
            EXPECT_GT(label.mesh_volume, 0.0);
        }
    }
}

} // namespace
} // namespace voroprobe
