#include "self_intersections.h"

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"

namespace voroprobe
{
namespace
{

std::size_t count(const TriangleMesh& mesh)
{
    return find_self_intersections(mesh).size();
}

TEST(SelfIntersections, an_icosphere_and_a_torus_have_none)
{
    EXPECT_EQ(count(sample::icosphere(3)), 0U);
    EXPECT_EQ(count(sample::torus(24, 12)), 0U);
}

TEST(SelfIntersections, two_spheres_that_overlap_cross)
{
    TriangleMesh mesh = sample::icosphere(2);
    sample::append(mesh, sample::icosphere(2), {2.5, 0, 0});
    EXPECT_EQ(count(mesh), 0U);
    sample::append(mesh, sample::icosphere(2), {1.2, 0, 0});
    EXPECT_GT(count(mesh), 0U);
}

TEST(SelfIntersections, triangles_without_a_common_corner_cross)
{
    const TriangleMesh mesh{
        .vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {3, 3, 0.5}},
        .faces = {{0, 1, 2}, {3, 4, 5}}};
    EXPECT_EQ(find_self_intersections(mesh), (std::vector<FacePair>{{0, 1}}));
}

TEST(SelfIntersections, triangles_that_touch_in_a_point_they_do_not_share_meet)
{
    const TriangleMesh mesh{
        .vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, 0}, {0.5, 0.5, 1}, {3, 3, 1}},
        .faces = {{0, 1, 2}, {3, 4, 5}}};
    EXPECT_EQ(count(mesh), 1U);
}

TEST(SelfIntersections, triangles_with_one_common_corner_cross_or_do_not)
{
    TriangleMesh mesh{.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, -1}, {1, 1, 1}},
                      .faces = {{0, 1, 2}, {0, 3, 4}}};
    EXPECT_EQ(count(mesh), 1U);
    mesh.faces[1] = {3, 0, 4}; // the order of the corners plays no part
    EXPECT_EQ(count(mesh), 1U);
    mesh.vertices[3] = {-1, -1, -1};
    mesh.vertices[4] = {-1, -1, 1};
    EXPECT_EQ(count(mesh), 0U);
}

TEST(SelfIntersections, neighbours_cross_only_where_one_is_folded_onto_the_other)
{
    TriangleMesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.4, 0.7, 0}},
                      .faces = {{0, 1, 2}, {1, 0, 3}}};
    EXPECT_EQ(count(mesh), 1U);
    mesh.vertices[3].z = 1e-12;
    EXPECT_EQ(count(mesh), 0U);
    mesh.vertices[3] = {0.4, -0.7, 0};
    EXPECT_EQ(count(mesh), 0U);
}

TEST(SelfIntersections, doubled_faces_and_faces_without_area_are_found)
{
    const TriangleMesh doubled{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                               .faces = {{0, 1, 2}, {0, 2, 1}}};
    EXPECT_EQ(find_self_intersections(doubled), (std::vector<FacePair>{{0, 1}}));
    const TriangleMesh flat{.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, .faces = {{0, 1, 2}}};
    EXPECT_EQ(find_self_intersections(flat), (std::vector<FacePair>{{0, 0}}));
}

} // namespace
} // namespace voroprobe
