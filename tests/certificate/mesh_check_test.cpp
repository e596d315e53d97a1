#include "certificate/mesh_check.h"

#include <numbers>

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"

namespace voroprobe
{
namespace
{

TEST(MeshPieces, a_sphere_and_a_torus_are_told_apart_with_their_handles)
{
    TriangleMesh mesh = sample::icosphere(3);
    sample::append(mesh, sample::torus(40, 20), {10, 0, 0});
    const MeshPieces found = split_into_pieces(mesh);

    ASSERT_EQ(found.pieces.size(), 2U);
    EXPECT_EQ(found.pieces[0].genus(), 0);
    EXPECT_EQ(found.pieces[1].genus(), 1);
    EXPECT_EQ(found.pieces[0].faces + found.pieces[1].faces, mesh.faces.size());
    EXPECT_TRUE(found.pieces[0].closed() && found.pieces[1].closed());
    EXPECT_NEAR(found.pieces[0].enclosed_volume, 4.0 / 3.0 * std::numbers::pi, 0.1);
    EXPECT_NEAR(found.pieces[1].area, 12.0 * std::numbers::pi * std::numbers::pi, 2.0);
    EXPECT_LT(found.pieces[0].box.max.x, found.pieces[1].box.min.x);
}

TEST(MeshPieces, that_share_only_a_vertex_have_their_own_euler_characteristics)
{
    TriangleMesh mesh = sample::tetrahedron();
    sample::append(mesh, sample::tetrahedron(),
                   {-1, 0, 0}); // its vertex (1, 0, 0) falls on the first's origin
    const TriangleMesh welded = weld(mesh);
    ASSERT_EQ(welded.vertices.size(), 7U);

    const MeshPieces found = split_into_pieces(welded);
    ASSERT_EQ(found.pieces.size(), 2U);
    EXPECT_EQ(found.pieces[0].euler_characteristic, 2);
    EXPECT_EQ(found.pieces[1].euler_characteristic, 2);
}

TEST(MeshPieces, that_share_an_edge_are_one_with_a_crowded_edge)
{
    const TriangleMesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                            .faces = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
    const MeshPieces found = split_into_pieces(mesh);
    ASSERT_EQ(found.pieces.size(), 1U);
    EXPECT_EQ(found.pieces[0].crowded_edges, 1U);
    EXPECT_EQ(found.pieces[0].boundary_edges, 6U);
}

TEST(MeshPieces, of_a_mesh_without_faces_are_none)
{
    EXPECT_TRUE(split_into_pieces({}).pieces.empty());
}

TEST(MeshCheck, finds_nothing_wrong_with_a_sphere)
{
    const MeshCheck check = check_mesh(sample::icosphere(3), 40.0);
    EXPECT_EQ(defects(check), std::nullopt);
    EXPECT_EQ(check.faces_below_shown_angle, (std::array<std::size_t, 3>{0, 0, 0}));
    EXPECT_EQ(check.faces_below_angle_bound, 0U);
    EXPECT_EQ(check.duplicate_faces, 0U);
    EXPECT_NEAR(check.enclosed_volume, 4.0 / 3.0 * std::numbers::pi, 0.1);
}

TEST(MeshCheck, names_the_hole_of_a_sphere_that_lacks_a_face)
{
    TriangleMesh mesh = sample::icosphere(2);
    mesh.faces.pop_back();
    EXPECT_EQ(defects(check_mesh(mesh)), "3 edges on one face only");
}

TEST(MeshCheck, names_a_face_that_winds_against_its_neighbours)
{
    TriangleMesh mesh = sample::icosphere(2);
    std::swap(mesh.faces[5][0], mesh.faces[5][1]);
    EXPECT_EQ(defects(check_mesh(mesh)), "3 edges whose faces wind against each other");
}

TEST(MeshCheck, names_a_sphere_turned_inside_out)
{
    TriangleMesh mesh = sample::icosphere(2);
    for (TriangleMesh::Face& face : mesh.faces)
        std::swap(face[0], face[1]);
    EXPECT_EQ(defects(check_mesh(mesh)), "faces that wind inward");
}

TEST(MeshCheck, counts_doubled_and_flat_faces)
{
    const MeshCheck check = check_mesh({.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}},
                                        .faces = {{0, 1, 2}, {2, 1, 0}, {0, 1, 3}, {0, 0, 1}}});
    EXPECT_EQ(check.duplicate_faces, 1U);
    EXPECT_EQ(check.flat_faces, 2U);
    EXPECT_EQ(check.self_intersections, (std::vector<FacePair>{{0, 1}})) << "the doubled one on the first";
    EXPECT_EQ(check.topology.degenerate_faces, 1U);
}

TEST(MeshCheck, counts_faces_by_their_smallest_angle)
{
    const MeshCheck check = check_mesh(
        {.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 0.3, 0}, {1, 0.1, 0}}, .faces = {{0, 1, 2}, {0, 1, 3}}},
        17.0);
    EXPECT_EQ(check.faces_below_shown_angle, (std::array<std::size_t, 3>{1, 2, 2}));
    EXPECT_EQ(check.faces_below_angle_bound, 2U) << "atan 0.3 is 16.7 degrees";
}

TEST(MeshCheck, objects_may_overlap_but_not_cross_themselves)
{
    TriangleMesh crossing = sample::icosphere(2);
    sample::append(crossing, sample::icosphere(2), {1.0, 0.1, 0.2});
    TriangleMesh neighbour = sample::icosphere(2);
    transform(neighbour, {{{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {-1.0, 0.1, 0.2}});
    const std::size_t crossing_itself = check_mesh(crossing).self_intersections.size();
    ASSERT_GT(crossing_itself, 0U);

    const std::vector<MeshPart> apart{{.name = "a", .mesh = sample::icosphere(2)},
                                      {.name = "b", .mesh = neighbour}};
    const MeshCheck of_apart = check_objects(apart);
    EXPECT_TRUE(of_apart.self_intersections.empty());
    EXPECT_FALSE(defects(of_apart));
    ASSERT_EQ(of_apart.object_overlaps.size(), 1U);
    EXPECT_EQ(of_apart.object_overlaps[0].first, 0U);
    EXPECT_EQ(of_apart.object_overlaps[0].second, 1U);
    EXPECT_EQ(of_apart.object_overlaps[0].face_pairs, check_mesh(merged(apart)).self_intersections.size());

    const std::vector<MeshPart> beside{{.name = "b", .mesh = neighbour}, {.name = "c", .mesh = crossing}};
    const MeshCheck of_beside = check_objects(beside);
    EXPECT_EQ(of_beside.self_intersections.size(), crossing_itself);
    EXPECT_TRUE(defects(of_beside));
}

TEST(MeshCheck, objects_with_a_common_interface_touch_in_all_its_faces)
{
    const std::vector<MeshPart> twins{{.name = "a", .mesh = sample::icosphere(1)},
                                      {.name = "b", .mesh = sample::icosphere(1)},
                                      {.name = "c", .mesh = sample::icosphere(1)}};
    const MeshCheck check = check_objects(twins);
    EXPECT_FALSE(defects(check));
    ASSERT_EQ(check.object_overlaps.size(), 3U);
    for (const ObjectOverlap& overlap : check.object_overlaps)
        EXPECT_GE(overlap.face_pairs, twins[0].mesh.faces.size());
}

} // namespace
} // namespace voroprobe
