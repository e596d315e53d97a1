#include "mesh/topology.h"

#include <gtest/gtest.h>

#include "sample_meshes.h"

namespace voroprobe
{
namespace
{

using sample::append;
using sample::icosphere;
using sample::tetrahedron;
using sample::torus;

TEST(Topology, an_empty_mesh_is_a_closed_manifold_without_components)
{
    const TriangleMesh mesh;
    EXPECT_TRUE(is_closed_manifold(mesh));
    EXPECT_EQ(count_components(mesh), 0U);
    EXPECT_EQ(euler_characteristic(mesh), 0);
}

TEST(Topology, a_tetrahedron_is_a_sphere)
{
    EXPECT_TRUE(is_closed_manifold(tetrahedron()));
    EXPECT_EQ(count_components(tetrahedron()), 1U);
    EXPECT_EQ(euler_characteristic(tetrahedron()), 2);
}

TEST(Topology, a_grid_on_a_torus_has_euler_characteristic_zero)
{
    const TriangleMesh mesh = torus(12, 7);
    EXPECT_TRUE(is_closed_manifold(mesh));
    EXPECT_EQ(count_components(mesh), 1U);
    EXPECT_EQ(euler_characteristic(mesh), 0);
}

TEST(Topology, pieces_are_numbered_by_their_first_face)
{
    TriangleMesh mesh = tetrahedron();
    append(mesh, torus(5, 4), {10, 0, 0});
    append(mesh, tetrahedron(), {0, 10, 0});
    std::swap(mesh.faces[1], mesh.faces.back());

    const auto component = component_of_faces(mesh);
    EXPECT_EQ(count_components(mesh), 3U);
    EXPECT_EQ(euler_characteristic(mesh), 4);
    EXPECT_EQ(component[0], 0U);
    EXPECT_EQ(component[1], 1U);
    EXPECT_EQ(component[2], 0U);
    EXPECT_EQ(component[4], 2U);
    EXPECT_EQ(component.back(), 0U);
}

TEST(Topology, tetrahedra_that_share_a_vertex_are_two_pieces_and_a_bow_tie)
{
    TriangleMesh mesh = tetrahedron();
    mesh.vertices.insert(mesh.vertices.end(), {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
    mesh.faces.insert(mesh.faces.end(), {{0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {5, 6, 0}});

    const MeshTopology topology = analyze_topology(mesh);
    EXPECT_EQ(topology.components, 2U);
    EXPECT_EQ(topology.non_manifold_vertices, 1U);
    EXPECT_EQ(topology.non_manifold_edges, 0U);
    EXPECT_TRUE(topology.closed());
    EXPECT_TRUE(topology.oriented());
    EXPECT_FALSE(topology.manifold());
    EXPECT_FALSE(is_closed_manifold(mesh));
}

TEST(Topology, tetrahedra_that_share_an_edge_have_one_non_manifold_edge_with_its_two_ends)
{
    TriangleMesh mesh = tetrahedron();
    mesh.vertices.insert(mesh.vertices.end(), {{0, -1, 0}, {0, 0, -1}});
    mesh.faces.insert(mesh.faces.end(), {{0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {4, 0, 5}});

    const MeshTopology topology = analyze_topology(mesh);
    EXPECT_EQ(topology.components, 1U);
    EXPECT_EQ(topology.non_manifold_edges, 1U);
    EXPECT_EQ(topology.non_manifold_vertices, 2U);
    EXPECT_EQ(topology.boundary_edges, 0U);
    EXPECT_FALSE(topology.manifold());
}

TEST(Topology, tetrahedra_that_share_a_face_have_three_non_manifold_edges)
{
    TriangleMesh mesh = tetrahedron();
    mesh.vertices.push_back({1, 1, 1});
    mesh.faces.insert(mesh.faces.end(), {{1, 4, 2}, {2, 4, 3}, {3, 4, 1}}); // face {1, 2, 3} stays

    const MeshTopology topology = analyze_topology(mesh);
    EXPECT_EQ(topology.non_manifold_edges, 3U);
    EXPECT_EQ(topology.non_manifold_vertices, 3U);
    EXPECT_EQ(topology.boundary_edges, 0U);
}

TEST(Topology, a_moebius_strip_is_manifold_with_boundary_but_not_oriented)
{
    const std::uint32_t n = 7;
    TriangleMesh mesh{.vertices = std::vector<Point3>(std::size_t{2} * n),
                      .faces = {}}; // bottom i, top n + i; combinatorics only
    for (std::uint32_t i = 0; i < n; ++i)
    {
        const bool last = i + 1 == n; // where the strip closes with top and bottom exchanged
        const std::uint32_t next_bottom = last ? n : i + 1;
        const std::uint32_t next_top = last ? 0 : n + i + 1;
        mesh.faces.push_back({i, next_bottom, next_top});
        mesh.faces.push_back({i, next_top, n + i});
    }

    const MeshTopology topology = analyze_topology(mesh);
    EXPECT_TRUE(topology.manifold());
    EXPECT_EQ(topology.misoriented_edges, 1U);
    EXPECT_EQ(topology.boundary_edges, 2 * n);
    EXPECT_EQ(topology.euler_characteristic, 0);
    EXPECT_FALSE(topology.closed());
    EXPECT_FALSE(topology.oriented());
}

TEST(Topology, a_flipped_face_disagrees_along_its_three_edges)
{
    TriangleMesh mesh = icosphere(1);
    std::swap(mesh.faces[5][0], mesh.faces[5][1]);

    const MeshTopology topology = analyze_topology(mesh);
    EXPECT_EQ(topology.misoriented_edges, 3U);
    EXPECT_TRUE(topology.closed());
    EXPECT_TRUE(topology.manifold());
    EXPECT_FALSE(is_closed_manifold(mesh));
}

TEST(Topology, a_hole_leaves_boundary_edges_and_open_fans_that_are_manifold)
{
    TriangleMesh mesh = icosphere(1);
    mesh.faces.pop_back();

    const MeshTopology topology = analyze_topology(mesh);
    EXPECT_EQ(topology.boundary_edges, 3U);
    EXPECT_EQ(topology.euler_characteristic, 1);
    EXPECT_TRUE(topology.manifold());
    EXPECT_FALSE(topology.closed());
}

TEST(Topology, faces_that_meet_in_one_vertex_only_make_it_non_manifold)
{
    const TriangleMesh mesh{.vertices = std::vector<Point3>(5), .faces = {{0, 1, 2}, {0, 3, 4}}};

    const MeshTopology topology = analyze_topology(mesh);
    EXPECT_EQ(topology.components, 2U);
    EXPECT_EQ(topology.non_manifold_vertices, 1U);
    EXPECT_EQ(topology.boundary_edges, 6U);
}

TEST(Topology, an_unused_vertex_is_counted_and_changes_nothing_else)
{
    TriangleMesh mesh = tetrahedron();
    mesh.vertices.push_back({5, 5, 5});

    const MeshTopology topology = analyze_topology(mesh);
    EXPECT_EQ(topology.unused_vertices, 1U);
    EXPECT_EQ(topology.euler_characteristic, 2);
    EXPECT_TRUE(topology.manifold());
    EXPECT_FALSE(is_closed_manifold(mesh));
}

TEST(Topology, a_degenerate_face_is_counted_and_otherwise_collapsed)
{
    TriangleMesh mesh = tetrahedron();
    mesh.faces.push_back({0, 0, 1});
    mesh.faces.push_back({3, 3, 3});

    const MeshTopology topology = analyze_topology(mesh);
    EXPECT_EQ(topology.degenerate_faces, 2U);
    EXPECT_EQ(topology.non_manifold_edges, 0U);
    EXPECT_EQ(topology.euler_characteristic, 2);
    EXPECT_FALSE(topology.closed());
    EXPECT_FALSE(topology.manifold());

    const auto component = component_of_faces(mesh);
    EXPECT_EQ(component[4], component[0]); // through the edge {0, 1}
    EXPECT_EQ(component[5], 1U);           // has no edge at all
}

TEST(Topology, welding_a_triangle_soup_restores_the_surface)
{
    const TriangleMesh sphere = icosphere(2);
    TriangleMesh soup;
    for (const TriangleMesh::Face& face : sphere.faces)
    {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (std::size_t i = 0; i < 3; ++i)
            soup.vertices.push_back(sphere.corner(face, i));
        soup.faces.push_back({first, first + 1, first + 2});
    }
    EXPECT_EQ(count_components(soup), sphere.faces.size());

    const TriangleMesh welded = weld(soup);
    EXPECT_EQ(welded.vertices.size(), sphere.vertices.size());
    EXPECT_TRUE(is_closed_manifold(welded));
    EXPECT_EQ(euler_characteristic(welded), 2);
    for (std::size_t f = 0; f < sphere.faces.size(); ++f)
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(welded.corner(welded.faces[f], i), sphere.corner(sphere.faces[f], i));
}

TEST(Topology, welding_joins_negative_zero_with_zero)
{
    const TriangleMesh mesh{.vertices = {{0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}},
                            .faces = {{0, 1, 2}, {3, 2, 1}}};
    EXPECT_EQ(weld(mesh).vertices.size(), 3U);
    EXPECT_EQ(weld(mesh).faces[1][0], 0U);
}

TEST(Topology, welding_collapses_a_face_whose_corners_coincide)
{
    const TriangleMesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, .faces = {{0, 1, 2}}};
    EXPECT_EQ(analyze_topology(weld(mesh)).degenerate_faces, 1U);
}

} // namespace
} // namespace voroprobe
