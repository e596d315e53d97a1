#include "mesher/seeded_mesher.h"

#include <cstring>
#include <utility>

#include <gtest/gtest.h>

#include "mesh/topology.h"
#include "oracles/sphere_union_oracle.h"
#include "oracles/trilinear_oracle.h"
#include "random_volumes.h"

namespace voroprobe
{
namespace
{

constexpr MeshingOptions kOptions{
    .max_facet_radius = 1.0, .max_facet_distance = 0.1, .floor_radius = 0.2, .reach_lower_bound = 0.5};

SphereUnionOracle row_of_spheres()
{
    std::vector<Sphere> spheres;
    for (int i = 0; i < 5; ++i)
        spheres.push_back({{5.0 * i, 0.7 * i, 0.3 * i * i}, 1.0 + 0.25 * i});
    spheres.push_back({{20.0, 2.8, 4.8}, 1.0}); // within the last one
    return SphereUnionOracle(std::move(spheres));
}

bool same_bytes(const TriangleMesh& a, const TriangleMesh& b)
{
    return a.vertices.size() == b.vertices.size() && a.faces == b.faces &&
           std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(Point3)) == 0;
}

TEST(Determinism, two_runs_give_the_same_bytes)
{
    const SphereUnionOracle spheres = row_of_spheres();
    EXPECT_TRUE(same_bytes(mesh_surface(spheres, kOptions).mesh, mesh_surface(spheres, kOptions).mesh));

    for (const VolumeKind kind :
         {VolumeKind::kWhiteNoise, VolumeKind::kSmoothNoise, VolumeKind::kIntegers, VolumeKind::kSpecks,
          VolumeKind::kCheckerboard, VolumeKind::kThinSheets, VolumeKind::kThroughBorder})
    {
        const RandomVolume random = make_random_volume(kind, 3);
        const auto first = make_trilinear_oracle(random.volume, random.isovalue);
        const auto second = make_trilinear_oracle(make_random_volume(kind, 3).volume, random.isovalue);
        EXPECT_TRUE(same_bytes(mesh_surface(*first, kOptions).mesh, mesh_surface(*second, kOptions).mesh))
            << random.name;
    }
}

TEST(Determinism, any_number_of_threads_gives_the_same_bytes)
{
    const RandomVolume random = make_random_volume(VolumeKind::kSmoothNoise, 5);
    const auto oracle = make_trilinear_oracle(random.volume, random.isovalue);
    MeshingOptions options = kOptions;
    const TriangleMesh on_one = mesh_surface(*oracle, options).mesh;
    for (const std::size_t threads : {2U, 3U, 0U})
    {
        options.threads = threads;
        EXPECT_TRUE(same_bytes(on_one, mesh_surface(*oracle, options).mesh)) << threads;
    }
}

TEST(Determinism, subdomains_refined_side_by_side_give_the_same_bytes)
{
    const SphereUnionOracle spheres = row_of_spheres();
    MeshingOptions options = kOptions;
    options.max_facet_radius = 0.08;
    options.floor_radius = 0.02;
    options.threads = 1;
    const MeshingResult on_one = mesh_surface(spheres, options);
    EXPECT_GT(on_one.statistics.insertions_side_by_side, on_one.statistics.insertions / 2);
    EXPECT_EQ(count_components(on_one.mesh), 6U);
    options.threads = 2;
    EXPECT_TRUE(same_bytes(on_one.mesh, mesh_surface(spheres, options).mesh));
}

TEST(Determinism, what_was_meshed_before_plays_no_part)
{
    const RandomVolume random = make_random_volume(VolumeKind::kSmoothNoise, 4);
    const auto oracle = make_trilinear_oracle(random.volume, random.isovalue);
    const TriangleMesh alone = mesh_surface(*oracle, kOptions).mesh;
    mesh_surface(row_of_spheres(), kOptions);
    EXPECT_TRUE(same_bytes(alone, mesh_surface(*oracle, kOptions).mesh));
}

TEST(IsolatedVertices, one_at_a_time_and_all_at_once_find_the_same_components)
{
    MeshingOptions options = kOptions;
    options.isolated_vertices = IsolatedVertices::kOneAtATime;
    const std::size_t one_at_a_time = count_components(mesh_surface(row_of_spheres(), options).mesh);
    options.isolated_vertices = IsolatedVertices::kAllAtOnce;
    const std::size_t all_at_once = count_components(mesh_surface(row_of_spheres(), options).mesh);
    EXPECT_EQ(one_at_a_time, all_at_once);
    EXPECT_EQ(all_at_once, 6U);
}

TEST(Statistics, add_up)
{
    const MeshingResult result = mesh_surface(row_of_spheres(), kOptions);
    const MeshingStatistics& s = result.statistics;
    EXPECT_EQ(s.components_by_initialization + s.components_by_isolated_vertex + s.components_by_probing +
                  s.components_by_refinement,
              count_components(result.mesh));
    EXPECT_EQ(s.components_by_initialization, 1U);
    EXPECT_GT(s.queries_probing, 0U);
    EXPECT_GT(s.queries_initialization, 0U);
    EXPECT_GT(s.queries_refinement, s.insertions);
    EXPECT_GT(s.region_lookups, s.insertions);
    EXPECT_GE(s.insertions, result.mesh.vertices.size());
    EXPECT_EQ(s.contacts_carved, 0U);
    EXPECT_GT(s.seconds_refinement, 0.0);
}

} // namespace
} // namespace voroprobe
