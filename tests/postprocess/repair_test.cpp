#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "postprocess/repair.h"

namespace voroprobe
{
namespace
{

using sample::icosphere;

TEST(Repair, a_sound_mesh_stays_as_it_is)
{
    const RepairResult result = repair(icosphere(2));
    EXPECT_EQ(result.faces_dropped + result.vertices_split + result.faces_turned + result.holes_closed, 0U);
    EXPECT_TRUE(is_closed_manifold(result.mesh));
    EXPECT_DOUBLE_EQ(enclosed_volume(result.mesh), enclosed_volume(icosphere(2)));
}

TEST(Repair, faces_that_wind_the_wrong_way_are_turned)
{
    TriangleMesh mesh = icosphere(2);
    for (std::size_t f = 0; f < mesh.faces.size(); f += 3)
        std::swap(mesh.faces[f][1], mesh.faces[f][2]);
    const RepairResult result = repair(mesh);
    EXPECT_TRUE(is_closed_manifold(result.mesh));
    EXPECT_EQ(result.faces_turned, (mesh.faces.size() + 2) / 3);
    EXPECT_GT(enclosed_volume(result.mesh), 0.0);
}

TEST(Repair, a_mesh_inside_out_is_turned_and_a_cavity_winds_inward)
{
    TriangleMesh mesh = icosphere(2, 2.0);
    for (TriangleMesh::Face& face : mesh.faces)
        std::swap(face[1], face[2]);
    sample::append(mesh, icosphere(2, 1.0));
    const RepairResult result = repair(mesh);
    EXPECT_NEAR(enclosed_volume(result.mesh),
                enclosed_volume(icosphere(2, 2.0)) - enclosed_volume(icosphere(2, 1.0)), 1e-9);
}

TEST(Repair, holes_are_closed_up_to_a_size)
{
    TriangleMesh mesh = icosphere(3);
    mesh.faces.erase(mesh.faces.begin() + 100);
    mesh.faces.erase(mesh.faces.begin(), mesh.faces.begin() + 40);
    const RepairResult all = repair(mesh);
    EXPECT_TRUE(is_closed_manifold(all.mesh));
    EXPECT_EQ(euler_characteristic(all.mesh), 2);
    EXPECT_GE(all.holes_closed, 2U);
    const RepairResult small = repair(mesh, {.max_hole_rim = 0.8});
    EXPECT_EQ(small.holes_closed, 1U);
    EXPECT_GE(small.holes_left, 1U);
}

TEST(Repair, useless_faces_and_vertices_go)
{
    TriangleMesh mesh = icosphere(1);
    const std::size_t count = mesh.faces.size();
    mesh.faces.push_back(mesh.faces[3]);
    mesh.faces.push_back({0, 0, 1});
    mesh.vertices.push_back({9, 9, 9});
    const RepairResult result = repair(mesh);
    EXPECT_EQ(result.faces_dropped, 2U);
    EXPECT_EQ(result.mesh.faces.size(), count);
    EXPECT_TRUE(is_closed_manifold(result.mesh));
}

TEST(Repair, balls_that_share_a_vertex_are_parted)
{
    TriangleMesh mesh = icosphere(1);
    TriangleMesh other = icosphere(1);
    const Vec3 away = 2.0 * mesh.vertices[0];
    for (Point3& p : other.vertices)
        p = p + away;
    std::uint32_t touching = 0;
    for (std::uint32_t v = 0; v < other.vertices.size(); ++v)
        if (distance(other.vertices[v], mesh.vertices[0]) < 1e-9)
            touching = v;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    sample::append(mesh, other);
    for (TriangleMesh::Face& face : mesh.faces)
        for (std::uint32_t& v : face)
            v = v == first + touching ? 0 : v;
    ASSERT_GT(analyze_topology(mesh).non_manifold_vertices, 0U);
    const RepairResult result = repair(mesh);
    EXPECT_EQ(result.vertices_split, 1U);
    EXPECT_TRUE(is_closed_manifold(result.mesh));
}

} // namespace
} // namespace voroprobe
