#include "surface_distance.h"

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "oracles/sphere_union_oracle.h"

namespace voroprobe
{
namespace
{

constexpr double kRounding = 1e-12;

TEST(SurfaceDistance, of_an_icosphere_is_its_deepest_face_center)
{
    const TriangleMesh mesh = sample::icosphere(2);
    double deepest = 0.0;
    for (const TriangleMesh::Face& face : mesh.faces)
        deepest = std::max(
            deepest, 1.0 - norm((mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3.0));
    const auto to_sphere = [](const Point3& p) { return 1.0 - norm(p); };
    EXPECT_NEAR(largest_distance_from_faces(mesh, to_sphere, 6), deepest, 0.02 * deepest);

    const SphereUnionOracle oracle({{{0, 0, 0}, 1.0}});
    const double along_normals = largest_distance_from_faces(mesh, oracle, 0.2, 6);
    EXPECT_GE(along_normals, deepest - kRounding);
    EXPECT_LE(along_normals, 1.1 * deepest);

    Random random(1);
    const double from_sphere = largest_distance_from_points(sample_surface(oracle, 5000, random), mesh);
    EXPECT_LE(from_sphere, deepest + kRounding);
    EXPECT_GE(from_sphere, 0.8 * deepest);
}

TEST(SurfaceDistance, sees_a_part_that_is_missing)
{
    const SphereUnionOracle oracle({{{0, 0, 0}, 1.0}, {{4, 0, 0}, 1.0}});
    Random random(1);
    const auto points = sample_surface(oracle, 2000, random);
    EXPECT_GT(largest_distance_from_points(points, sample::icosphere(2)), 3.9);
    EXPECT_TRUE(std::isinf(largest_distance_from_points(points, {})));
}

TEST(SurfaceDistance, sees_faces_where_there_is_no_surface)
{
    const SphereUnionOracle oracle({{{0, 0, 0}, 1.0}});
    TriangleMesh mesh = sample::icosphere(2);
    sample::append(mesh, sample::icosphere(2), {4, 0, 0});
    EXPECT_TRUE(std::isinf(largest_distance_from_faces(mesh, oracle, 0.2, 2)));
}

} // namespace
} // namespace voroprobe
