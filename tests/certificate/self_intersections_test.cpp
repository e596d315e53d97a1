#include "certificate/self_intersections.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "../mesher/self_intersections.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

//! Random faces over few vertices at few places, in so many planes: every degenerate contact there is.
TriangleMesh crumpled_mesh(std::uint64_t seed, std::uint64_t planes)
{
    Random random(seed);
    TriangleMesh mesh;
    for (int v = 0; v < 60; ++v)
        mesh.vertices.push_back({static_cast<double>(random.below(6)), static_cast<double>(random.below(6)),
                                 static_cast<double>(random.below(planes))});
    for (int f = 0; f < 80; ++f)
        mesh.faces.push_back({static_cast<std::uint32_t>(random.below(60)),
                              static_cast<std::uint32_t>(random.below(60)),
                              static_cast<std::uint32_t>(random.below(60))});
    return mesh;
}

TEST(SelfIntersectionsOfAnyMesh, are_those_of_the_independent_checker)
{
    for (std::uint64_t seed = 0; seed < 150; ++seed)
    {
        const TriangleMesh mesh = crumpled_mesh(seed, 1 + seed % 6);
        ASSERT_EQ(self_intersections(mesh), find_self_intersections(mesh)) << "seed " << seed;
    }
}

TEST(SelfIntersectionsOfAnyMesh, of_two_crossing_spheres_are_those_of_the_independent_checker)
{
    TriangleMesh mesh = sample::icosphere(4);
    sample::append(mesh, sample::icosphere(4), {1.2, 0.1, 0.2});
    const auto found = self_intersections(mesh);
    EXPECT_GT(found.size(), 50U);
    EXPECT_EQ(found, find_self_intersections(mesh));
}

TEST(SelfIntersectionsOfAnyMesh, of_a_sphere_with_vertices_out_of_place_are_those_of_the_independent_checker)
{
    for (std::uint64_t seed = 0; seed < 20; ++seed)
    {
        TriangleMesh mesh = sample::icosphere(3); // edges of about 0.14
        Random random(seed);
        for (int i = 0; i < 60; ++i)
            mesh.vertices[random.below(mesh.vertices.size())] += Vec3{
                0.4 * random.uniform() - 0.2, 0.4 * random.uniform() - 0.2, 0.4 * random.uniform() - 0.2};
        const auto found = self_intersections(mesh);
        EXPECT_FALSE(found.empty());
        ASSERT_EQ(found, find_self_intersections(mesh)) << "seed " << seed;
    }
}

TEST(SelfIntersectionsOfAnyMesh, those_of_the_first_faces_are_among_all_of_them)
{
    for (std::uint64_t seed = 0; seed < 150; ++seed)
    {
        const TriangleMesh mesh = crumpled_mesh(seed, 1 + seed % 6);
        const auto pairs = self_intersections(mesh);
        for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{5}, mesh.faces.size()})
            ASSERT_EQ(first_faces_intersect(mesh, count),
                      std::any_of(pairs.begin(), pairs.end(),
                                  [&](const FacePair& pair) { return pair.first < count; }))
                << "seed " << seed << ", " << count << " faces";
    }
}

TEST(SelfIntersectionsOfAnyMesh, an_icosphere_and_a_torus_have_none)
{
    EXPECT_TRUE(self_intersections(sample::icosphere(4)).empty());
    EXPECT_TRUE(self_intersections(sample::torus(48, 24)).empty());
}

TEST(SelfIntersectionsOfAnyMesh, a_mesh_without_faces_has_none)
{
    EXPECT_TRUE(self_intersections({}).empty());
}

} // namespace
} // namespace voroprobe
