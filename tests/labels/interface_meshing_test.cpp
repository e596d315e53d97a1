#include "labels/interface_meshing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "certificate/self_intersections.h"
#include "labels/cavity_labels.h"
#include "labels/joint_meshing.h"
#include "labels/label_cavities.h"
#include "labels/small_parts.h"
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

//! In samples of a grid with `nx` times `ny` in a slice.
std::size_t sample_at(int i, int j, int k, std::size_t nx, std::size_t ny)
{
    const auto at = [](int index) { return static_cast<std::size_t>(index); };
    return at(i) + nx * (at(j) + ny * at(k));
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
        EXPECT_NEAR(label.mesh_volume, label.voxel_volume, 0.02 * label.voxel_volume);
        EXPECT_EQ(label.cavities_meshed, label.cavities_expected);
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

//! A shell of label 1, two voxels thick, round a ball of label 2 and, beside it, one round nothing.
Volume two_shells()
{
    std::vector<std::uint8_t> samples;
    for (int k = 0; k < 16; ++k)
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 32; ++i)
            {
                const double filled = distance({1.0 * i, 1.0 * j, 1.0 * k}, {8, 8, 8});
                const double hollow = distance({1.0 * i, 1.0 * j, 1.0 * k}, {23, 8, 8});
                const bool is_shell = (filled > 3.5 && filled <= 5.5) || (hollow > 3.5 && hollow <= 5.5);
                samples.push_back(is_shell ? 1 : filled <= 3.5 ? 2 : 0);
            }
    return make_volume({.size = {32, 16, 16}, .spacing = kUnit, .direction = {}, .origin = {}},
                       std::move(samples));
}

TEST(InterfaceMeshing, volumes_and_cavities_are_kept_whatever_fills_these)
{
    const LabelSurvey survey(two_shells());
    ASSERT_EQ(count_cavities(survey, 0), 2U);
    for (const auto& [place, label] : mesh_jointly(survey))
    {
        EXPECT_TRUE(label.complete());
        EXPECT_EQ(label.cavities_expected, place == 0 ? 2U : 0U);
        EXPECT_EQ(label.cavities_meshed, label.cavities_expected);
        EXPECT_NEAR(label.mesh_volume, label.voxel_volume, 0.01 * label.voxel_volume);
        EXPECT_TRUE(self_intersections(label.mesh).empty());
    }
}

//! A block of label 1 with holes of background: single voxels, two that touch at an edge, two at a corner,
//! one that touches the outside at an edge, one of two voxels; and a dent, which is none.
Volume pierced_block()
{
    const std::array<std::size_t, 3> size{18, 14, 14};
    std::vector<std::uint8_t> samples;
    for (int k = 0; k < 14; ++k)
        for (int j = 0; j < 14; ++j)
            for (int i = 0; i < 18; ++i)
                samples.push_back(i >= 2 && i < 16 && j >= 2 && j < 12 && k >= 2 && k < 12 ? 1 : 0);
    for (const auto& [i, j, k] : {SampleIndex{4, 4, 4},
                                  {8, 5, 5},
                                  {9, 6, 5},
                                  {5, 8, 8},
                                  {6, 9, 9},
                                  {12, 6, 6},
                                  {13, 6, 6},
                                  {15, 9, 8},
                                  {14, 8, 8}})
        samples[sample_at(i, j, k, 18, 14)] = 0;
    return make_volume({.size = size, .spacing = kUnit, .direction = {}, .origin = {}}, std::move(samples));
}

TEST(InterfaceMeshing, holes_of_background_are_kept_though_they_touch_at_edges_and_corners)
{
    const LabelSurvey survey(pierced_block());
    ASSERT_EQ(count_cavities(survey, 0), 7U);
    const auto meshes = mesh_jointly(survey);
    ASSERT_EQ(meshes.size(), 1U);
    const LabelMesh& block = meshes.at(0);
    EXPECT_TRUE(block.complete());
    EXPECT_EQ(block.cavities_meshed, 7U);
    EXPECT_NEAR(block.mesh_volume, block.voxel_volume, 0.02 * block.voxel_volume);
    EXPECT_TRUE(self_intersections(block.mesh).empty());
}

TEST(InterfaceMeshing, specks_within_a_label_keep_their_volume)
{
    std::vector<std::uint8_t> samples;
    for (int k = 0; k < 14; ++k)
        for (int j = 0; j < 14; ++j)
            for (int i = 0; i < 14; ++i)
                samples.push_back(std::min({i, j, k}) >= 2 && std::max({i, j, k}) < 12 ? 1 : 0);
    const auto at = [](int i, int j, int k) { return sample_at(i, j, k, 14, 14); };
    samples[at(4, 4, 4)] = 2;
    samples[at(8, 5, 5)] = samples[at(9, 5, 5)] = 3;
    samples[at(5, 9, 8)] = samples[at(6, 9, 8)] = samples[at(6, 8, 8)] = 4;
    const LabelSurvey survey(make_volume(
        {.size = {14, 14, 14}, .spacing = kUnit, .direction = {}, .origin = {}}, std::move(samples)));
    for (const auto& [place, label] : mesh_jointly(survey))
    {
        EXPECT_TRUE(label.complete());
        EXPECT_NEAR(label.mesh_volume, label.voxel_volume, 0.02 * label.voxel_volume) << place;
        EXPECT_TRUE(self_intersections(label.mesh).empty());
    }
}

TEST(CavityLabels, stand_for_the_labels_of_the_map_voxel_by_voxel)
{
    const std::array<std::size_t, 3> size{12, 10, 11};
    for (std::uint64_t seed = 0; seed < 10; ++seed)
    {
        const Volume volume = random_labels(size, 3, seed);
        const LabelSurvey survey(volume);
        const CavityLabels apart = label_cavities_apart(survey, all_labels(survey));
        for (int k = 0; k < 11; ++k)
            for (int j = 0; j < 10; ++j)
            {
                std::array<LabelValue, 12> found{};
                for (const LabelRun& run : apart.survey.row(j, k))
                    if (const PartitionLabel of = apart.stands_for[apart.survey.parts()[run.part].label + 1])
                        std::fill(found.begin() + run.first, found.begin() + run.end,
                                  survey.labels()[of - 1].value);
                for (std::size_t i = 0; i < 12; ++i)
                    EXPECT_EQ(found[i], std::lround(volume.at(i, static_cast<std::size_t>(j),
                                                              static_cast<std::size_t>(k))));
            }
    }
}

TEST(CavityLabels, know_the_cavities_around_them)
{
    const LabelSurvey block(pierced_block());
    const CavityLabels apart = label_cavities_apart(block, all_labels(block));
    ASSERT_EQ(apart.survey.labels().size(), 1U + 7U);
    EXPECT_TRUE(apart.cavities_around[1].empty());
    std::set<std::uint32_t> cavities;
    for (PartitionLabel label = 2; label <= 8; ++label)
    {
        EXPECT_EQ(apart.stands_for[label], 0U);
        ASSERT_EQ(apart.cavities_around[label].count(1), 1U);
        cavities.insert(apart.cavities_around[label].at(1));
    }
    EXPECT_EQ(cavities.size(), 7U);
}

TEST(CavityLabels, of_labels_that_are_not_asked_for_are_background)
{
    const LabelSurvey survey(two_shells());
    const std::vector<std::uint32_t> shells{0};
    const CavityLabels apart = label_cavities_apart(survey, shells);
    ASSERT_EQ(apart.survey.labels().size(), 3U);
    EXPECT_EQ(apart.survey.labels()[1].voxels, apart.survey.labels()[2].voxels); // the ball is background
    EXPECT_EQ(apart.stands_for, (std::vector<PartitionLabel>{0, 1, 0, 0}));
}

//! A block of label 1 that lies in label 2, with voxels of label 2 in it: one by itself, and two that touch
//! label 2 outside at an edge and at a corner.
Volume block_with_guests()
{
    std::vector<std::uint8_t> samples;
    for (int k = 0; k < 16; ++k)
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 16; ++i)
            {
                const int rim = std::min({i, j, k, 15 - i, 15 - j, 15 - k});
                samples.push_back(rim >= 4 ? 1 : rim >= 1 ? 2 : 0);
            }
    const auto at = [](int i, int j, int k) { return sample_at(i, j, k, 16, 16); };
    samples[at(8, 8, 8)] = 2;
    // Dents, whose bottoms are outside, and voxels that touch these.
    samples[at(4, 6, 6)] = 2;
    samples[at(5, 7, 6)] = 2;
    samples[at(4, 9, 9)] = 2;
    samples[at(5, 10, 10)] = 2;
    return make_volume({.size = {16, 16, 16}, .spacing = kUnit, .direction = {}, .origin = {}},
                       std::move(samples));
}

TEST(InterfaceMeshing,
     voxels_of_a_neighbour_are_cavities_though_they_touch_the_rest_of_it_at_edges_and_corners)
{
    const LabelSurvey survey(block_with_guests());
    ASSERT_EQ(count_cavities(survey, 0), 3U);
    ASSERT_EQ(survey.labels()[1].parts.size(), 2U);
    const auto meshes = mesh_jointly(survey);
    for (const auto& [place, label] : meshes)
    {
        EXPECT_TRUE(label.complete());
        EXPECT_EQ(label.cavities_meshed, label.cavities_expected);
        EXPECT_NEAR(label.mesh_volume, label.voxel_volume, 0.02 * label.voxel_volume);
    }
    EXPECT_EQ(meshes.at(0).parts_in_pieces, 0U);
    EXPECT_EQ(meshes.at(1).parts_in_pieces, 1U); // the one outside, of which the two guests are
}

TEST(SmallParts, that_touch_what_stands_for_the_same_may_not_grow)
{
    const LabelSurvey survey(block_with_guests());
    const CavityLabels apart = label_cavities_apart(survey, all_labels(survey));
    const std::vector<std::uint32_t> alone = small_parts_alone(apart);
    std::vector<SampleIndex> first_voxels;
    first_voxels.reserve(alone.size());
    for (const std::uint32_t part : alone)
        first_voxels.push_back(apart.survey.parts()[part].first_voxel);
    EXPECT_EQ(std::count(first_voxels.begin(), first_voxels.end(), SampleIndex{8, 8, 8}), 1);
    EXPECT_EQ(std::count(first_voxels.begin(), first_voxels.end(), SampleIndex{5, 7, 6}), 0);
    EXPECT_EQ(std::count(first_voxels.begin(), first_voxels.end(), SampleIndex{5, 10, 10}), 0);

    // Holes of background: those that touch none of it at edges and corners.
    const LabelSurvey block(pierced_block());
    const CavityLabels holes = label_cavities_apart(block, all_labels(block));
    std::size_t growing = 0;
    for (const std::uint32_t part : small_parts_alone(holes))
        growing += holes.stands_for[holes.survey.parts()[part].label + 1] == 0 ? 1 : 0;
    EXPECT_EQ(growing, 2U);
}

TEST(LabelPartition, parts_have_the_volume_of_their_voxels_once_they_are_balanced)
{
    std::vector<std::uint8_t> samples(std::size_t{16} * 16 * 16, 1);
    const auto at = [](int i, int j, int k) { return sample_at(i, j, k, 16, 16); };
    samples[at(4, 4, 4)] = 2;
    samples[at(10, 10, 4)] = samples[at(11, 11, 4)] = samples[at(12, 11, 5)] = 3;
    for (int i = 4; i < 10; ++i)
        samples[at(i, 11, 11)] = 4;
    const LabelSurvey survey(make_volume(
        {.size = {16, 16, 16}, .spacing = kUnit, .direction = {}, .origin = {}}, std::move(samples)));
    LabelPartition partition(survey, all_labels(survey), kUnit);
    const auto volume_of = [&](PartitionLabel label)
    {
        constexpr int kFine = 8;
        std::size_t points = 0;
        for (int n = 0; n < 16 * 16 * 16 * kFine * kFine * kFine; ++n)
        {
            const auto place = [](int digit) { return (digit % (16 * kFine) + 0.5) / kFine - 0.5; };
            const Point3 p{place(n), place(n / (16 * kFine)), place(n / (16 * kFine) / (16 * kFine))};
            points += partition.label(p) == label ? 1 : 0;
        }
        return static_cast<double>(points) / (kFine * kFine * kFine);
    };
    EXPECT_LT(volume_of(2), 0.6);
    partition.balance(survey, {1, 2, 3});
    EXPECT_NEAR(volume_of(2), 1.0, 0.3); // to the grain of 27 points a voxel
    EXPECT_NEAR(volume_of(3), 3.0, 0.6);
    EXPECT_NEAR(volume_of(4), 6.0, 0.6);
}

TEST(LabelCavities, are_counted_as_a_flood_through_faces_does)
{
    const std::array<std::size_t, 3> size{12, 10, 11};
    for (std::uint64_t seed = 0; seed < 20; ++seed)
    {
        const Volume volume = random_labels(size, 3, seed);
        const auto& samples = std::get<std::vector<std::uint16_t>>(volume.samples);
        const LabelSurvey survey(volume);
        for (std::uint32_t place = 0; place < survey.labels().size(); ++place)
        {
            // All that is not the label, in a frame that joins what leaves the volume.
            const std::array<std::size_t, 3> framed{size[0] + 2, size[1] + 2, size[2] + 2};
            std::vector<bool> others(framed[0] * framed[1] * framed[2], true);
            for (std::size_t n = 0; n < samples.size(); ++n)
            {
                const std::size_t i = n % size[0] + 1;
                const std::size_t j = n / size[0] % size[1] + 1;
                const std::size_t k = n / size[0] / size[1] + 1;
                others[i + framed[0] * (j + framed[1] * k)] = samples[n] != survey.labels()[place].value;
            }
            EXPECT_EQ(count_cavities(survey, place), count_components(framed, others, Neighbours::kFaces) - 1)
                << "seed " << seed << ", label " << place;
        }
    }
}

TEST(InterfaceMeshing, the_same_labels_give_the_same_mesh_wherever_memory_lies)
{
    const LabelSurvey survey(random_labels({40, 40, 40}, 6, 1));
    const CavityLabels apart = label_cavities_apart(survey, all_labels(survey));
    const LabelPartition partition(apart.survey, all_labels(apart.survey), kUnit);
    const auto mesh = [&] { return mesh_interfaces(survey, apart, kUnit, partition, kCriteria); };
    const InterfaceMesh first = mesh();
    // Freed blocks in the heap's way: what is allocated now has other places, and another order of them.
    std::vector<std::unique_ptr<std::vector<char>>> blocks;
    for (std::size_t size = 1 << 10; size < 1 << 22; size += size / 3)
        for (int i = 0; i < 4; ++i)
            blocks.push_back(std::make_unique<std::vector<char>>(size));
    for (std::size_t i = 0; i < blocks.size(); i += 2)
        blocks[i].reset();
    const InterfaceMesh second = mesh();
    EXPECT_TRUE(first.vertices == second.vertices);
    EXPECT_TRUE(std::equal(first.faces.begin(), first.faces.end(), second.faces.begin(), second.faces.end(),
                           [](const InterfaceFace& a, const InterfaceFace& b) {
                               return a.vertices == b.vertices && a.front == b.front && a.behind == b.behind;
                           }));
}

TEST(InterfaceMeshing, no_two_vertices_are_one_but_for_rounding)
{
    const LabelSurvey survey(random_labels({20, 20, 20}, 6, 1));
    const CavityLabels apart = label_cavities_apart(survey, all_labels(survey));
    const LabelPartition partition(apart.survey, all_labels(apart.survey), kUnit);
    const InterfaceMesh mesh = mesh_interfaces(survey, apart, kUnit, partition, kCriteria);
    double shortest = std::numeric_limits<double>::infinity();
    for (const InterfaceFace& face : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i)
            shortest = std::min(shortest, distance(mesh.vertices[face.vertices[i]],
                                                   mesh.vertices[face.vertices[(i + 1) % 3]]));
    EXPECT_GT(shortest, 1e-3); // a millionth would be lost in 32-bit coordinates
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
            EXPECT_TRUE(self_intersections(label.mesh).empty());
        }
    }
}

} // namespace
} // namespace voroprobe
