#include "certificate/flat_stars.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

//! `corners` faces around vertex 0, that together turn `rounds` times about the z axis.
TriangleMesh fan(std::uint32_t corners, int rounds, double height)
{
    TriangleMesh mesh;
    mesh.vertices.push_back({0, 0, height});
    for (std::uint32_t i = 0; i < corners; ++i)
    {
        const double angle = 2.0 * std::numbers::pi * rounds * i / corners;
        mesh.vertices.push_back({std::cos(angle), std::sin(angle), 0});
        mesh.faces.push_back({0, 1 + i, 1 + (i + 1) % corners});
    }
    return mesh;
}

TEST(FlatStars, are_all_of_an_uneven_sphere_and_of_an_uneven_torus)
{
    Random random(1);
    for (TriangleMesh mesh : {sample::icosphere(3), sample::torus(48, 24)})
    {
        for (Point3& p : mesh.vertices) // else some are too even to call
            p += 1e-3 * Vec3{random.uniform(), random.uniform(), random.uniform()};
        const std::vector<std::uint8_t> flat = find_flat_stars(mesh);
        EXPECT_EQ(std::count(flat.begin(), flat.end(), 1), std::ssize(mesh.vertices));
    }
}

TEST(FlatStars, go_round_once)
{
    EXPECT_EQ(find_flat_stars(fan(7, 1, 0.3))[0], 1);
    EXPECT_EQ(find_flat_stars(fan(4, 1, 0.0))[0], 1); // corners on the very axes
    EXPECT_EQ(find_flat_stars(fan(7, 2, 0.3))[0], 0);
    EXPECT_EQ(find_flat_stars(fan(11, 3, 0.0))[0], 0);
}

TEST(FlatStars, are_one_closed_round)
{
    TriangleMesh open = fan(7, 1, 0.3);
    open.faces.pop_back();
    EXPECT_EQ(find_flat_stars(open)[0], 0);
    TriangleMesh turned = fan(7, 1, 0.3);
    std::swap(turned.faces[3][1], turned.faces[3][2]);
    EXPECT_EQ(find_flat_stars(turned)[0], 0);
    TriangleMesh doubled = fan(7, 1, 0.3);
    doubled.faces.push_back(doubled.faces.front());
    EXPECT_EQ(find_flat_stars(doubled)[0], 0);
    TriangleMesh two = fan(7, 1, 0.3); // that touch at a vertex
    sample::append(two, fan(5, 1, 0.3), {0, 0, 0});
    for (TriangleMesh::Face& face : two.faces)
        std::replace(face.begin(), face.end(), 8U, 0U);
    EXPECT_EQ(find_flat_stars(two)[0], 0);
}

TEST(FlatStars, have_no_face_that_is_folded_over_or_without_area)
{
    TriangleMesh folded = fan(7, 1, 0.0);
    folded.vertices[3] = folded.vertices[6]; // over to the other side
    EXPECT_EQ(find_flat_stars(folded)[0], 0);
    TriangleMesh thin = fan(7, 1, 0.0);
    thin.vertices[3] = thin.vertices[2];
    EXPECT_EQ(find_flat_stars(thin)[0], 0);
    TriangleMesh hair = fan(7, 1, 0.0);
    hair.vertices[3] = hair.vertices[2] + Vec3{0, 1e-17, 0};
    EXPECT_EQ(find_flat_stars(hair)[0], 0);
}

} // namespace
} // namespace voroprobe
