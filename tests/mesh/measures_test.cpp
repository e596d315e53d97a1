#include "mesh/circumcircle.h"
#include "mesh/measures.h"
#include "mesh/vertex_normals.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sample_meshes.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

using sample::icosphere;
using sample::tetrahedron;
using sample::torus;

constexpr double kPi = std::numbers::pi;

TEST(Measures, an_empty_mesh_measures_nothing)
{
    const TriangleMesh mesh;
    EXPECT_EQ(area(mesh), 0.0);
    EXPECT_EQ(enclosed_volume(mesh), 0.0);
    EXPECT_EQ(measure_angles(mesh).min_deg, 0.0);
    EXPECT_EQ(measure_angles(mesh).mean_min_deg, 0.0);
    EXPECT_EQ(measure_angles(mesh).max_deg, 0.0);
    EXPECT_EQ(count_faces_below_angle(mesh, 30.0), 0U);
}

TEST(Measures, a_corner_of_the_cube_has_the_textbook_area_and_volume)
{
    EXPECT_NEAR(area(tetrahedron()), 1.5 + std::sqrt(3.0) / 2.0, 1e-15);
    EXPECT_NEAR(enclosed_volume(tetrahedron()), 1.0 / 6.0, 1e-16);
}

TEST(Measures, a_mesh_that_faces_inward_encloses_negative_volume)
{
    TriangleMesh mesh = tetrahedron();
    for (TriangleMesh::Face& face : mesh.faces)
        std::swap(face[0], face[1]);
    EXPECT_NEAR(enclosed_volume(mesh), -1.0 / 6.0, 1e-16);
}

TEST(Measures, a_fine_torus_approaches_pappus)
{
    const TriangleMesh mesh = torus(200, 100, 3.0, 1.0);
    EXPECT_NEAR(area(mesh), 4 * kPi * kPi * 3.0, 0.002 * 4 * kPi * kPi * 3.0);
    EXPECT_NEAR(enclosed_volume(mesh), 2 * kPi * kPi * 3.0, 0.002 * 2 * kPi * kPi * 3.0);
}

TEST(Measures, volume_keeps_its_digits_far_from_the_origin)
{
    const double near = enclosed_volume(icosphere(3, 1.0));
    TriangleMesh mesh = icosphere(3, 1.0);
    for (Point3& p : mesh.vertices)
        p += {0x1.0p20, -0x1.0p21, 0x1.0p19};
    EXPECT_NEAR(enclosed_volume(mesh), near, 1e-8); // vertices themselves are rounded by 2^-32
}

TEST(Measures, angles_of_a_triangle_are_in_the_order_of_its_corners)
{
    const auto angles = triangle_angles_deg({0, 0, 0}, {1, 0, 0}, {0, std::sqrt(3.0), 0});
    EXPECT_NEAR(angles[0], 90.0, 1e-12);
    EXPECT_NEAR(angles[1], 60.0, 1e-12);
    EXPECT_NEAR(angles[2], 30.0, 1e-12);
}

TEST(Measures, a_needle_keeps_the_digits_of_its_small_angle)
{
    const auto angles = triangle_angles_deg({0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0});
    EXPECT_NEAR(angles[0] * kPi / 180.0, 1e-9, 1e-24);
}

TEST(Measures, angles_at_coinciding_corners_are_zero)
{
    const Point3 p{1, 2, 3};
    for (const double angle : triangle_angles_deg(p, p, p))
        EXPECT_EQ(angle, 0.0);
    EXPECT_EQ(triangle_angles_deg(p, p, {0, 0, 0})[0], 0.0);
    EXPECT_EQ(triangle_angles_deg(p, p, {0, 0, 0})[1], 0.0);
}

TEST(Measures, angles_over_a_mesh_are_the_extremes_and_the_mean)
{
    const TriangleMesh mesh = tetrahedron(); // three faces 90-45-45 and one equilateral
    const AngleMeasures measures = measure_angles(mesh);
    EXPECT_NEAR(measures.min_deg, 45.0, 1e-12);
    EXPECT_NEAR(measures.mean_min_deg, (3 * 45.0 + 60.0) / 4, 1e-12);
    EXPECT_NEAR(measures.max_deg, 90.0, 1e-12);
}

TEST(Measures, a_face_at_the_bound_is_not_below_it)
{
    EXPECT_EQ(count_faces_below_angle(tetrahedron(), 45.0), 0U);
    EXPECT_EQ(count_faces_below_angle(tetrahedron(), 45.1), 3U);
    EXPECT_EQ(count_faces_below_angle(tetrahedron(), 60.1), 4U);
}

TEST(Measures, faces_below_a_bound_are_those_whose_smallest_angle_is)
{
    Random random(1);
    TriangleMesh mesh;
    for (std::uint32_t f = 0; f < 300; ++f)
    {
        for (int i = 0; i < 3; ++i) // flat ones, and corners at one place, among them
            mesh.vertices.push_back({static_cast<double>(random.below(4)),
                                     static_cast<double>(random.below(4)),
                                     f % 2 == 0 ? 0.0 : random.uniform()});
        mesh.faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    }
    for (const double bound_deg : {-1.0, 0.0, 1e-7, 10.0, 30.0, 45.0, 60.0, 88.9999999, 89.0, 90.0, 120.0})
    {
        std::size_t expected = 0;
        for (const TriangleMesh::Face& face : mesh.faces)
        {
            const auto angles =
                triangle_angles_deg(mesh.corner(face, 0), mesh.corner(face, 1), mesh.corner(face, 2));
            expected += *std::min_element(angles.begin(), angles.end()) < bound_deg - 1e-9 ? 1 : 0;
        }
        EXPECT_EQ(count_faces_below_angle(mesh, bound_deg), expected) << bound_deg << " degrees";
    }
}

TEST(VertexNormals, of_a_cube_corner_are_its_diagonal_whatever_the_triangles)
{
    const TriangleMesh corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {5, 5, 5}},
                              {{0, 2, 4}, {0, 4, 1}, {0, 1, 3}, {0, 3, 2}}}; // one side in two triangles
    const std::vector<Vec3> normals = vertex_normals(corner);
    EXPECT_NEAR(norm(normals[0] - normalized(Vec3{-1, -1, -1})), 0.0, 1e-12);
    EXPECT_EQ(normals[5], Vec3{}); // on no face
}

TEST(Circumcircle, is_as_far_from_all_corners_and_in_their_plane)
{
    const Point3 a{1, 2, 3};
    const Point3 b{4, 2.5, -1};
    const Point3 c{0, 7, 2};
    const auto circle = circumcircle(a, b, c);
    ASSERT_TRUE(circle);
    for (const Point3& corner : {a, b, c})
        EXPECT_NEAR(distance(circle->center, corner), circle->radius, 1e-12);
    EXPECT_NEAR(dot(circle->center - a, circle->normal), 0.0, 1e-12);
    EXPECT_GT(dot(cross(b - a, c - a), circle->normal), 0.0);
    EXPECT_FALSE(circumcircle(a, a + Vec3{1, 1, 1}, a + Vec3{2, 2, 2}));
}

} // namespace
} // namespace voroprobe
