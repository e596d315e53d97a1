//! What a mesh costs, counted: a mesher that asks more, inserts more or sorts more than it has to is slow on
//! every machine, and no clock is needed to see it.

#include <array>
#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "io/volume_reader.h"
#include "mesher/seeded_mesher.h"
#include "oracles/trilinear_oracle.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

//! Most of each that is let through: a tenth more than the largest of eight starts, and two hundredths more
//! insertions. Each start gives another mesh, and costs a few percent more or less.
struct Bounds
{
    double queries_per_insertion;        //!< about dual edges
    double region_lookups_per_insertion; //!< one for each Delaunay cell, some more for repairs
    double stale_entries_per_insertion;  //!< bad facets that vanished before their turn
    double insertions_per_vertex;
};

struct Subject
{
    std::string name;
    std::shared_ptr<const Volume> (*volume)();
    double isovalue;
    Bounds bounds;
};

std::shared_ptr<const Volume> head_ct()
{
    return std::make_shared<const Volume>(
        read_volume(std::string(VOROPROBE_SOURCE_DIR "/testdata/headsq_ct.nrrd")).volume);
}

//! Ripples near the Nyquist limit.
std::shared_ptr<const Volume> ripples()
{
    constexpr double kHalfSide = 20.0;
    return std::make_shared<const Volume>(sample_volume(
        marschner_lobb_phantom({kHalfSide, kHalfSide, kHalfSide}, kHalfSide), {41, 41, 41}, {1, 1, 1}));
}

//! Five nested surfaces, smooth.
std::shared_ptr<const Volume> shells()
{
    return std::make_shared<const Volume>(sample_volume(
        nested_shells_phantom({24.3, 24.1, 24.7}, {22.0, 17.5, 13.0, 8.5, 4.0}), {49, 49, 49}, {1, 1, 1}));
}

//! Printed by the names of tests.
void PrintTo(const Subject& subject, std::ostream* out)
{
    *out << subject.name;
}

class Counters : public testing::TestWithParam<Subject>
{
};

MeshingResult mesh_from(const LevelledVolume& levelled, const std::shared_ptr<const Inventory>& inventory,
                        const Point3& start)
{
    const double voxel = levelled.volume->geometry.min_spacing();
    const auto oracle = make_trilinear_oracle(levelled, inventory);
    return mesh_surface(*oracle, {.max_facet_radius = 2.0 * voxel,
                                  .max_facet_distance = 0.3 * voxel,
                                  .floor_radius = 0.25 * voxel,
                                  .reach_lower_bound = voxel,
                                  .seeds = {start}});
}

double per(std::size_t amount, std::size_t count)
{
    return static_cast<double>(amount) / static_cast<double>(count);
}

TEST_P(Counters, stay_within_their_bounds_wherever_the_mesh_begins)
{
    constexpr std::size_t kStarts = 3;
    const auto& [name, make_volume, isovalue, bounds] = GetParam();
    const LevelledVolume levelled = level_volume(make_volume(), isovalue);
    const auto inventory = std::make_shared<const Inventory>(*make_height_field(levelled), 1);
    const auto& surfaces = inventory->surfaces();
    for (std::size_t i = 0; i < kStarts; ++i)
    {
        const Point3 start = surfaces[i * (surfaces.size() - 1) / (kStarts - 1)].point;
        const MeshingResult result = mesh_from(levelled, inventory, start);
        const MeshingStatistics& counts = result.statistics;
        ASSERT_EQ(result.status, MeshingStatus::kDone);
        ASSERT_GT(result.mesh.vertices.size(), 1000U);
        SCOPED_TRACE(name + " from surface " + std::to_string(i));
        EXPECT_LE(per(counts.queries_refinement, counts.insertions), bounds.queries_per_insertion);
        EXPECT_LE(per(counts.region_lookups, counts.insertions), bounds.region_lookups_per_insertion);
        EXPECT_LE(per(counts.stale_queue_entries, counts.insertions), bounds.stale_entries_per_insertion);
        EXPECT_LE(per(counts.insertions, result.mesh.vertices.size()), bounds.insertions_per_vertex);
    }
}

INSTANTIATE_TEST_SUITE_P(Volumes, Counters,
                         testing::Values(Subject{"head_ct", head_ct, 1150.5, {20.5, 26.0, 1.75, 1.035}},
                                         Subject{"ripples", ripples, 0.0, {22.5, 22.8, 1.15, 1.07}},
                                         Subject{"shells", shells, 0.0, {17.0, 21.1, 2.9, 1.02}}),
                         [](const auto& tested) { return tested.param.name; });

} // namespace
} // namespace voroprobe
