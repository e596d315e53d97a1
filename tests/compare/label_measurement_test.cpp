#include "compare/label_measurement.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../mesh/sample_meshes.h"
#include "certificate/self_intersections.h"
#include "compare/label_frame.h"
#include "compare/mask_cubes.h"
#include "label_map_phantom.h"

namespace voroprobe
{

namespace
{

constexpr MeasuringOptions kMeasuring{.mesh_samples = 4000};

//! The surface of a block of voxels, from its first to its last sample and half a voxel beyond: 12 faces.
TriangleMesh block(const Point3& first, const Point3& last)
{
    const Point3 a = first - Vec3{0.5, 0.5, 0.5};
    const Point3 b = last + Vec3{0.5, 0.5, 0.5};
    TriangleMesh mesh;
    for (unsigned corner = 0; corner < 8; ++corner)
        mesh.vertices.push_back({corner & 1U ? b.x : a.x, corner & 2U ? b.y : a.y, corner & 4U ? b.z : a.z});
    mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

std::vector<TriangleMesh> cubes_of(const LabelTask& task, CubesFinish finish)
{
    std::vector<TriangleMesh> meshes;
    for (const std::uint32_t label : task.labels)
    {
        const PartMask mask = mask_of_label(task, label);
        meshes.push_back(cubes_of_mask(mask, task.spacing, finish));
        transform(meshes.back(), grid_from_mask(task, mask));
    }
    return meshes;
}

TEST(LabelMeasurement, blocks_have_the_volume_of_their_voxels_and_every_part)
{
    std::vector<TriangleMesh> meshes{block({3, 3, 3}, {8, 8, 8}), block({9, 3, 3}, {14, 8, 8})};
    sample::append(meshes[1], block({20, 3, 3}, {22, 5, 5}));
    const auto json = measure_labels(meshes, three_blocks(), kMeasuring);
    EXPECT_EQ(json.at("vertices"), 24);
    EXPECT_EQ(json.at("faces"), 36);
    EXPECT_EQ(json.at("surfaces").at("expected"), 3);
    EXPECT_EQ(json.at("surfaces").at("meshed"), 3);
    EXPECT_NEAR(json.at("volume_mm3").get<double>(), 2 * 216 + 27, 1e-9);
    EXPECT_NEAR(json.at("area_mm2").get<double>(), 2 * 216 + 54, 1e-9);
    EXPECT_NEAR(json.at("labels").at("largest_volume_change").get<double>(), 0.0, 1e-12);
    EXPECT_EQ(json.at("labels").at("not_closed_manifold"), 0);
    EXPECT_NEAR(json.at("angles").at("min_deg").get<double>(), 45.0, 1e-9);
    EXPECT_EQ(json.at("topology").at("pieces"), 3);
    // At a corner the interpolant is a half where t^3 is, t being the way from the outer sample: the surface
    // passes the corner of the block at a distance of sqrt 3 (0.5^(1/3) - 0.5). Nowhere else is it farther.
    const double farthest = std::sqrt(3.0) * (std::cbrt(0.5) - 0.5);
    EXPECT_LE(json.at("distance").at("mm").at("max").get<double>(), farthest + 1e-6);
    EXPECT_GT(json.at("distance").at("mm").at("max").get<double>(), 0.9 * farthest);
}

TEST(LabelMeasurement, neighbours_that_touch_neither_cross_nor_hang_together)
{
    const LabelTask task = three_blocks();
    const std::vector<TriangleMesh> meshes = cubes_of(task, CubesFinish::kRough);
    TriangleMesh all;
    for (const TriangleMesh& mesh : meshes)
        sample::append(all, mesh);
    ASSERT_FALSE(self_intersections(all).empty()); // where they touch they have the same faces
    const auto json = measure_labels(meshes, task, kMeasuring);
    EXPECT_EQ(json.at("topology").at("self_intersections"), 0);
    EXPECT_EQ(json.at("topology").at("pieces"), 3);
    EXPECT_EQ(json.at("topology").at("closed"), true);
    EXPECT_EQ(json.at("topology").at("manifold"), true);
    EXPECT_EQ(json.at("topology").at("oriented"), true);
    EXPECT_EQ(json.at("surfaces").at("meshed"), 3);
}

TEST(LabelMeasurement, a_part_that_was_taken_away_is_missing_with_its_size_and_place)
{
    const std::vector<TriangleMesh> meshes{block({3, 3, 3}, {8, 8, 8}), block({9, 3, 3}, {14, 8, 8})};
    const auto json = measure_labels(meshes, three_blocks(), kMeasuring);
    EXPECT_EQ(json.at("surfaces").at("meshed"), 2);
    ASSERT_EQ(json.at("surfaces").at("missing").size(), 1U);
    const auto& missing = json.at("surfaces").at("missing").at(0);
    EXPECT_EQ(missing.at("voxels"), 27);
    EXPECT_EQ(missing.at("center_mm"), (nlohmann::ordered_json{21.0, 4.0, 4.0}));
    EXPECT_NEAR(json.at("labels").at("largest_volume_change").get<double>(), 27.0 / 243.0, 1e-12);
    // As near as the mesh comes to the far side of the part: from 14.5 to 22.5.
    EXPECT_GT(json.at("distance").at("mm").at("max").get<double>(), 7.5);
}

TEST(LabelMeasurement, a_label_without_a_mesh_is_counted_and_the_others_are_measured)
{
    const std::vector<TriangleMesh> meshes{block({3, 3, 3}, {8, 8, 8}), {}};
    const auto json = measure_labels(meshes, three_blocks(), kMeasuring);
    EXPECT_EQ(json.at("surfaces").at("meshed"), 1);
    EXPECT_EQ(json.at("labels").at("not_closed_manifold"), 1);
    EXPECT_EQ(json.at("labels").at("largest_volume_change"), 1.0);
    EXPECT_LT(json.at("distance").at("mm").at("max").get<double>(), 1.0);
}

TEST(LabelMeasurement, in_the_view_pieces_are_labels)
{
    const LabelTask task = three_blocks();
    const std::vector<TriangleMesh> meshes = cubes_of(task, CubesFinish::kRough);
    const ViewMesh view = make_label_view(meshes, task, 1000000);
    EXPECT_FALSE(view.decimated());
    EXPECT_EQ(view.mesh.faces.size(), meshes[0].faces.size() + meshes[1].faces.size());
    EXPECT_EQ(static_cast<std::size_t>(std::count(view.pieces.begin(), view.pieces.end(), 1U)),
              meshes[1].faces.size());
    EXPECT_TRUE(make_label_view(meshes, task, meshes[0].faces.size()).decimated());
}

} // namespace

} // namespace voroprobe
