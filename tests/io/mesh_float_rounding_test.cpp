#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "../mesh/sample_meshes.h"
#include "io/float_rounding.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "support/error.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

using sample::append;
using sample::icosphere;
using sample::torus;

Vec3 normal(const TriangleMesh& mesh, const TriangleMesh::Face& face)
{
    return cross(mesh.corner(face, 1) - mesh.corner(face, 0), mesh.corner(face, 2) - mesh.corner(face, 0));
}

std::size_t count_folded_faces(const TriangleMesh& rounded, const TriangleMesh& exact)
{
    std::size_t count = 0;
    for (const TriangleMesh::Face& face : exact.faces)
        count += dot(normal(rounded, face), normal(exact, face)) > 0.0 ? 0 : 1;
    return count;
}

double nearest_float(double x)
{
    const volatile float nearest = static_cast<float>(x); // see to_float() in float_rounding.cpp
    return nearest;
}

TriangleMesh plainly_rounded(TriangleMesh mesh)
{
    for (Point3& p : mesh.vertices)
        p = {nearest_float(p.x), nearest_float(p.y), nearest_float(p.z)};
    return mesh;
}

bool keeps_promises_in_floats(const TriangleMesh& mesh)
{
    const TriangleMesh rounded = plainly_rounded(mesh);
    return weld(rounded).vertices.size() == mesh.vertices.size() && count_folded_faces(rounded, mesh) == 0;
}

//! What the header says, and that no vertex went far: `units` in the last place of the largest coordinate,
//! per axis.
void expect_promises_kept(const FloatRounding& rounding, const TriangleMesh& exact, double units)
{
    const TriangleMesh& rounded = rounding.mesh;
    EXPECT_EQ(rounded.faces, exact.faces);
    EXPECT_TRUE(is_closed_manifold(weld(rounded)));
    EXPECT_EQ(weld(rounded).vertices.size(), exact.vertices.size());
    EXPECT_EQ(count_folded_faces(rounded, exact), 0U);

    const Box3 box = bounding_box(exact);
    double largest = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        largest = std::max({largest, std::abs(box.min[axis]), std::abs(box.max[axis])});
    const double unit = std::nextafter(static_cast<float>(largest), std::numeric_limits<float>::infinity()) -
                        static_cast<float>(largest);
    std::size_t moved = 0;
    for (std::size_t v = 0; v < exact.vertices.size(); ++v)
    {
        bool nearest = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const double actual = rounded.vertices[v][axis];
            EXPECT_EQ(actual, nearest_float(actual));
            EXPECT_LE(std::abs(actual - exact.vertices[v][axis]), (units + 0.5) * unit);
            nearest = nearest && actual == nearest_float(exact.vertices[v][axis]);
        }
        moved += nearest ? 0 : 1;
    }
    EXPECT_EQ(rounding.vertices_nudged, moved);
}

TriangleMesh moved_by(TriangleMesh mesh, const Vec3& offset)
{
    for (Point3& p : mesh.vertices)
        p += offset;
    return mesh;
}

TEST(FloatRounding, a_coarse_mesh_is_only_rounded)
{
    const TriangleMesh mesh = icosphere(3, 10.0 / 3.0);
    const FloatRounding rounding = round_to_float(mesh);
    EXPECT_EQ(rounding.vertices_nudged, 0U);
    EXPECT_EQ(rounding.mesh.vertices, plainly_rounded(mesh).vertices);
}

TEST(FloatRounding, an_empty_mesh_stays_empty)
{
    EXPECT_TRUE(round_to_float({}).mesh.vertices.empty());
}

TEST(FloatRounding, vertices_that_would_fall_together_are_parted_towards_their_own_side)
{
    // Two spheres that touch but for 1e-9: the poles fall together, and each may only go back to its own
    // sphere.
    const TriangleMesh lower = icosphere(2, 10.0);
    TriangleMesh mesh = lower;
    append(mesh, lower, {0, 0, 20.0 + 1e-9});
    ASSERT_FALSE(keeps_promises_in_floats(mesh));

    const FloatRounding rounding = round_to_float(mesh);
    EXPECT_EQ(rounding.vertices_nudged, 1U);
    expect_promises_kept(rounding, mesh, 1.0);

    double top_of_lower = -1e9;
    double bottom_of_upper = 1e9;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (v < lower.vertices.size())
            top_of_lower = std::max(top_of_lower, rounding.mesh.vertices[v].z);
        else
            bottom_of_upper = std::min(bottom_of_upper, rounding.mesh.vertices[v].z);
    EXPECT_LT(top_of_lower, bottom_of_upper);
}

TEST(FloatRounding, a_sliver_that_would_fold_is_unfolded)
{
    // An octahedron with one edge split next to its end, off the line by less than the floats resolve.
    TriangleMesh mesh{
        .vertices = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        .faces = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
    mesh.vertices.push_back({0.5 + 2e-9, 0.5 + 2e-9, 1e-9});
    mesh.faces[0] = {0, 6, 4};
    mesh.faces[4] = {6, 0, 5};
    mesh.faces.push_back({6, 1, 4});
    mesh.faces.push_back({1, 6, 5});
    // ... and a flat cap over face {1, 2, 4}: three faces that differ by 1e-9 from lying in one plane.
    mesh.vertices.push_back(Point3{-1, 1, 1} / 3.0 + Vec3{-1e-9, 1e-9, 1e-9});
    mesh.faces[1] = {1, 2, 7};
    mesh.faces.push_back({2, 4, 7});
    mesh.faces.push_back({4, 1, 7});
    mesh.vertices.push_back((mesh.vertices[1] + mesh.vertices[2]) / 2.0 *
                            (1.0 - 1e-9)); // almost on the edge {1, 2}
    mesh.faces[1] = {1, 8, 7};
    mesh.faces.push_back({8, 2, 7});
    mesh.faces[5] = {8, 1, 5};
    mesh.faces.push_back({2, 8, 5});
    ASSERT_TRUE(is_closed_manifold(mesh));

    const TriangleMesh far = moved_by(mesh, {100.1, -70.7, 33.3});
    expect_promises_kept(round_to_float(far), far, 3.0);
}

TEST(FloatRounding, thousands_of_slivers_are_unfolded)
{
    // A torus whose rings come in pairs 1e-6 apart at coordinates of 100, where floats are 7.6e-6 apart.
    TriangleMesh mesh = torus(40, 30, 60.0, 20.0);
    const std::uint32_t across = 30;
    Random random(7);
    for (std::uint32_t i = 1; i < 40; i += 2)
        for (std::uint32_t j = 0; j < across; ++j)
        {
            const Point3 before = mesh.vertices[(i - 1) * across + j];
            const Point3 here = mesh.vertices[i * across + j];
            mesh.vertices[i * across + j] =
                before + (1e-6 + 1e-7 * random.uniform()) * normalized(here - before);
        }
    mesh = moved_by(mesh, {17.77, -23.33, 31.41});
    ASSERT_FALSE(keeps_promises_in_floats(mesh));

    const FloatRounding rounding = round_to_float(mesh);
    EXPECT_GT(rounding.vertices_nudged, 0U);
    expect_promises_kept(rounding, mesh, 3.0);
}

TEST(FloatRounding, a_fine_mesh_far_from_the_origin_keeps_its_promises)
{
    // Edges of about 1e-3 at coordinates of 1e4, where floats are 9.8e-4 apart.
    const TriangleMesh mesh = moved_by(icosphere(3, 0.006), {1e4, -0.9e4, 1.1e4});
    ASSERT_FALSE(keeps_promises_in_floats(mesh));
    expect_promises_kept(round_to_float(mesh), mesh, 3.0);
}

TEST(FloatRounding, far_along_one_axis_is_enough_to_need_help)
{
    const TriangleMesh mesh = moved_by(icosphere(3, 0.004), {1e4, 0.0, 0.0});
    ASSERT_FALSE(keeps_promises_in_floats(mesh));
    expect_promises_kept(round_to_float(mesh), mesh, 3.0);
}

TEST(FloatRounding, the_same_mesh_is_rounded_the_same_way_twice)
{
    const TriangleMesh mesh = moved_by(icosphere(3, 0.006), {1e4, -0.9e4, 1.1e4});
    EXPECT_EQ(round_to_float(mesh).mesh.vertices, round_to_float(mesh).mesh.vertices);
}

TEST(FloatRounding, a_mesh_that_no_float_can_hold_is_refused_with_the_reason)
{
    const TriangleMesh mesh = moved_by(icosphere(2, 1e-4), {1e4, 1e4, 1e4}); // 162 vertices within one unit
    try
    {
        round_to_float(mesh);
        FAIL();
    }
    catch (const OutputError& error)
    {
        EXPECT_NE(std::string(error.what()).find("too fine for 32-bit floats"), std::string::npos)
            << error.what();
    }
}

TEST(FloatRounding, coordinates_beyond_the_range_of_floats_are_refused)
{
    EXPECT_THROW(round_to_float(moved_by(icosphere(0), {1e39, 0, 0})), OutputError);
    EXPECT_THROW(round_to_float(moved_by(icosphere(0), {std::nan(""), 0, 0})), OutputError);
}

TEST(FloatRounding, negative_zero_and_zero_are_one_place)
{
    // Two tetrahedra whose apexes differ by the sign of zero only.
    TriangleMesh mesh{.vertices = {{0.0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {-1, -1, 1}},
                      .faces = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
    TriangleMesh mirrored = mesh;
    for (Point3& p : mirrored.vertices)
        p = -p;
    for (TriangleMesh::Face& face : mirrored.faces)
        std::swap(face[0], face[1]);
    append(mesh, mirrored);
    ASSERT_TRUE(is_closed_manifold(mesh));

    const FloatRounding rounding = round_to_float(mesh);
    EXPECT_EQ(rounding.vertices_nudged, 1U);
    EXPECT_TRUE(is_closed_manifold(weld(rounding.mesh)));
}

} // namespace
} // namespace voroprobe
