#include "mesh/triangle_mesh.h"

#include <gtest/gtest.h>

#include "mesh/measures.h"
#include "sample_meshes.h"

namespace voroprobe
{
namespace
{

TEST(TriangleMesh, the_box_of_a_mesh_holds_its_vertices_and_that_of_none_is_empty)
{
    EXPECT_TRUE(bounding_box(TriangleMesh{}).empty());
    const Box3 box = bounding_box(sample::torus(16, 16, 3.0, 1.0));
    EXPECT_NEAR(box.max.x, 4.0, 1e-15);
    EXPECT_NEAR(box.min.z, -1.0, 1e-15);
}

TEST(TriangleMesh, faces_still_face_outward_after_any_affine_transform)
{
    const AffineTransform scaled{.linear = {{Vec3{2, 0, 0}, Vec3{0, 3, 0}, Vec3{1, 0, 0.5}}},
                                 .translation = {7, 8, 9}};
    const AffineTransform mirrored{.linear = {{Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}},
                                   .translation = {}};
    for (const AffineTransform& t : {scaled, mirrored})
    {
        TriangleMesh mesh = sample::icosphere(1);
        const double expected = enclosed_volume(mesh) * std::abs(determinant(t.linear));
        transform(mesh, t);
        EXPECT_NEAR(enclosed_volume(mesh), expected, 1e-12);
    }
}

TEST(TriangleMesh, a_transform_moves_the_vertices)
{
    TriangleMesh mesh = sample::tetrahedron();
    transform(mesh, {.linear = {}, .translation = {1, 2, 3}});
    EXPECT_EQ(mesh.vertices[1], (Point3{2, 2, 3}));
}

} // namespace
} // namespace voroprobe
