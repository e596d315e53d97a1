#include "labels/label_meshing.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "certificate/self_intersections.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "random_labels.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

const Vec3 kUnit{1, 1, 1};

LabelMeshingOptions options_with(const LabelSmoothing& smoothing)
{
    return {.criteria = {.max_facet_radius = 2.0,
                         .max_facet_distance = 0.3,
                         .floor_radius = 0.25,
                         .reach_lower_bound = 1.0},
            .smoothing = smoothing};
}

const std::vector<LabelSmoothing>& smoothings()
{
    static const std::vector<LabelSmoothing> all{{.method = SmoothingMethod::kNone},
                                                 {.method = SmoothingMethod::kGaussian, .sigma = 1.0},
                                                 {.method = SmoothingMethod::kAntialias}};
    return all;
}

std::map<std::uint32_t, LabelMesh> mesh_all(const LabelSurvey& survey, const LabelMeshingOptions& options,
                                            std::size_t threads = 1)
{
    std::vector<std::uint32_t> places(survey.labels().size());
    for (std::uint32_t i = 0; i < places.size(); ++i)
        places[i] = i;
    std::map<std::uint32_t, LabelMesh> meshes;
    mesh_labels(survey, places, kUnit, options, threads, nullptr,
                [&](LabelMesh mesh) { meshes.emplace(mesh.label, std::move(mesh)); });
    return meshes;
}

//! A mask of 1 where `inside` holds, as a label map.
LabelSurvey survey_of(const std::array<std::size_t, 3>& size,
                      const std::function<bool(std::size_t, std::size_t, std::size_t)>& inside)
{
    std::vector<std::uint8_t> samples;
    for (std::size_t k = 0; k < size[2]; ++k)
        for (std::size_t j = 0; j < size[1]; ++j)
            for (std::size_t i = 0; i < size[0]; ++i)
                samples.push_back(inside(i, j, k) ? 1 : 0);
    return LabelSurvey(
        make_volume({.size = size, .spacing = kUnit, .direction = {}, .origin = {}}, std::move(samples)));
}

LabelMesh mesh_only(const LabelSurvey& survey, const LabelSmoothing& smoothing)
{
    return mesh_all(survey, options_with(smoothing)).at(0);
}

TEST(LabelMeshing, a_blur_that_leaves_nothing_of_any_shape_is_refused)
{
    const LabelSurvey survey =
        survey_of({5, 5, 5}, [](auto i, auto j, auto k) { return i == 2 && j == 2 && k == 2; });
    for (const double sigma : {0.0, -1.0, 16.1, 50.0})
        EXPECT_THROW(mesh_all(survey, options_with({.method = SmoothingMethod::kGaussian, .sigma = sigma})),
                     UsageError);
    const auto meshes = mesh_all(survey, options_with({.method = SmoothingMethod::kGaussian, .sigma = 16.0}));
    EXPECT_TRUE(meshes.at(0).complete());
}

TEST(LabelMeshing, one_voxel_is_one_closed_piece_of_its_volume)
{
    const LabelSurvey survey =
        survey_of({5, 5, 5}, [](auto i, auto j, auto k) { return i == 2 && j == 2 && k == 2; });
    for (const LabelSmoothing& smoothing : smoothings())
    {
        const LabelMesh label = mesh_only(survey, smoothing);
        EXPECT_TRUE(label.complete());
        EXPECT_TRUE(is_closed_manifold(label.mesh));
        EXPECT_EQ(count_components(label.mesh), 1U);
        EXPECT_EQ(euler_characteristic(label.mesh), 2);
        EXPECT_NEAR(label.mesh_volume, 1.0, 0.02);
        EXPECT_LT(norm(bounding_box(label.mesh).center() - Point3{2, 2, 2}), 0.2);
    }
}

TEST(LabelMeshing, voxels_that_touch_at_a_corner_are_one_piece)
{
    const LabelSurvey survey =
        survey_of({6, 6, 6}, [](auto i, auto j, auto k) { return i == j && j == k && (i == 2 || i == 3); });
    for (const LabelSmoothing& smoothing : smoothings())
    {
        const LabelMesh label = mesh_only(survey, smoothing);
        EXPECT_TRUE(label.complete());
        EXPECT_EQ(count_components(label.mesh), 1U);
        EXPECT_TRUE(is_closed_manifold(label.mesh));
    }
}

TEST(LabelMeshing, a_label_that_fills_the_volume_is_closed_around_its_voxels)
{
    const LabelSurvey survey = survey_of({6, 5, 4}, [](auto, auto, auto) { return true; });
    const LabelMesh label = mesh_only(survey, {.method = SmoothingMethod::kGaussian, .sigma = 0.7});
    EXPECT_TRUE(label.complete());
    EXPECT_TRUE(is_closed_manifold(label.mesh));
    EXPECT_NEAR(label.mesh_volume, 120.0, 0.02 * 120.0);
    EXPECT_LT(bounding_box(label.mesh).min.x, 0.0);
    EXPECT_GT(bounding_box(label.mesh).max.x, 5.0);
}

TEST(LabelMeshing, a_cavity_of_one_voxel_is_kept)
{
    const LabelSurvey survey =
        survey_of({9, 9, 9},
                  [](auto i, auto j, auto k)
                  {
                      const auto within = [](auto x) { return x >= 2 && x <= 6; };
                      return within(i) && within(j) && within(k) && !(i == 4 && j == 4 && k == 4);
                  });
    for (const LabelSmoothing& smoothing : smoothings())
    {
        const LabelMesh label = mesh_only(survey, smoothing);
        EXPECT_TRUE(label.complete());
        EXPECT_EQ(label.cavities_expected, 1U);
        EXPECT_EQ(label.cavities_meshed, 1U);
        EXPECT_EQ(count_components(label.mesh), 2U);
        EXPECT_NEAR(label.mesh_volume, 124.0, 0.02 * 124.0);
    }
}

//! What the user sees in the segmentation is in the meshes: random label maps, every smoothing.
TEST(LabelMeshing, every_part_of_every_label_is_there_and_no_volume_changes)
{
    for (std::uint64_t seed = 0; seed < 4; ++seed)
    {
        const std::array<std::size_t, 3> size{18, 16, 14};
        const Volume volume = random_labels(size, 4, seed);
        const auto& samples = std::get<std::vector<std::uint16_t>>(volume.samples);
        const LabelSurvey survey(volume);
        for (const LabelSmoothing& smoothing : smoothings())
            for (const auto& [place, label] : mesh_all(survey, options_with(smoothing)))
            {
                std::vector<bool> belongs;
                for (const std::uint16_t sample : samples)
                    belongs.push_back(sample == survey.labels()[place].value);
                EXPECT_TRUE(label.complete())
                    << (label.broken_promises.empty() ? "" : label.broken_promises[0]);
                EXPECT_EQ(label.parts_meshed, count_components(size, belongs, Neighbours::kAll));
                EXPECT_EQ(count_components(label.mesh), label.parts_meshed + label.cavities_meshed);
                EXPECT_TRUE(is_closed_manifold(label.mesh));
                EXPECT_TRUE(self_intersections(label.mesh).empty());
                EXPECT_LT(std::abs(label.volume_change()), 0.02);
                EXPECT_NEAR(label.mesh_volume, enclosed_volume(label.mesh), 1e-6);
            }
    }
}

TEST(LabelMeshing, any_number_of_threads_gives_the_same_meshes)
{
    const LabelSurvey survey(random_labels({20, 16, 14}, 6, 42));
    const LabelMeshingOptions options = options_with(smoothings()[1]);
    const auto alone = mesh_all(survey, options, 1);
    const auto together = mesh_all(survey, options, 3);
    ASSERT_EQ(alone.size(), together.size());
    for (const auto& [place, label] : alone)
    {
        EXPECT_EQ(label.mesh.vertices, together.at(place).mesh.vertices);
        EXPECT_EQ(label.mesh.faces, together.at(place).mesh.faces);
    }
}

TEST(LabelMeshing, what_fails_when_a_label_is_handed_over_comes_out)
{
    const LabelSurvey survey(random_labels({12, 12, 12}, 3, 1));
    std::vector<std::uint32_t> places{0, 1};
    EXPECT_THROW(mesh_labels(survey, places, kUnit, options_with(smoothings()[0]), 2, nullptr,
                             [](const LabelMesh&) { throw OutputError("disk full"); }),
                 OutputError);
}

} // namespace
} // namespace voroprobe
