#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <optional>

#include "../mesh/sample_meshes.h"
#include "certificate/self_intersections.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "postprocess/deviation.h"
#include "postprocess/relaxation.h"
#include "support/error.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

using sample::icosphere;
using sample::torus;

//! Moves vertices at random within the surface of a sphere about the origin.
TriangleMesh shaken_sphere()
{
    TriangleMesh mesh = icosphere(4, 10.0);
    Random random(1);
    for (Point3& p : mesh.vertices)
        p = 10.0 * normalized(p + Vec3{random.uniform(-0.22, 0.22), random.uniform(-0.22, 0.22),
                                       random.uniform(-0.22, 0.22)});
    return mesh;
}

RelaxationResult relaxed(const TriangleMesh& mesh, double max_distance)
{
    const auto surface = std::make_shared<const MeshDistance>(mesh);
    return relax(mesh, {projection_onto(surface), face_distance_to(surface), max_distance});
}

TEST(Relaxation, raises_every_angle_of_a_shaken_sphere_above_33_degrees)
{
    const TriangleMesh before = shaken_sphere();
    ASSERT_LT(measure_angles(before).min_deg, 20.0);
    const RelaxationResult result = relaxed(before, 0.2);
    EXPECT_TRUE(is_closed_manifold(result.mesh));
    EXPECT_EQ(euler_characteristic(result.mesh), 2);
    EXPECT_GE(measure_angles(result.mesh).min_deg, 33.0);
    EXPECT_GE(measure_angles(result.mesh).mean_min_deg, 48.0);
    EXPECT_TRUE(self_intersections(result.mesh).empty());
    EXPECT_LE(deviation(before, result.mesh).max, 0.2);
}

TEST(Relaxation, keeps_handles)
{
    const RelaxationResult result = relaxed(torus(60, 12), 0.1);
    EXPECT_TRUE(is_closed_manifold(result.mesh));
    EXPECT_EQ(euler_characteristic(result.mesh), 0);
    EXPECT_EQ(count_components(result.mesh), 1U);
    EXPECT_GT(measure_angles(result.mesh).min_deg, measure_angles(torus(60, 12)).min_deg);
}

TEST(Relaxation, sheets_that_all_but_touch_stay_apart)
{
    TriangleMesh mesh = shaken_sphere();
    TriangleMesh inner = shaken_sphere();
    for (Point3& p : inner.vertices)
        p = 0.998 * p;
    for (TriangleMesh::Face& face : inner.faces)
        std::swap(face[1], face[2]);
    sample::append(mesh, inner);
    ASSERT_TRUE(self_intersections(mesh).empty());
    const RelaxationResult result = relaxed(mesh, 0.2);
    EXPECT_TRUE(self_intersections(result.mesh).empty());
    EXPECT_EQ(result.self_intersections, 0U);
    EXPECT_EQ(count_components(result.mesh), 2U);
    EXPECT_EQ(euler_characteristic(result.mesh), 4);
}

TEST(Relaxation, the_smallest_meshes_survive)
{
    for (const TriangleMesh& mesh : {sample::tetrahedron(), sample::icosahedron()})
    {
        const RelaxationResult result = relaxed(mesh, 0.1);
        EXPECT_TRUE(is_closed_manifold(result.mesh));
        EXPECT_EQ(euler_characteristic(result.mesh), 2);
        EXPECT_GT(enclosed_volume(result.mesh), 0.0);
    }
}

//! Vertices of a shaken sphere on an ellipsoid, whose tips bend far more than its waist.
TriangleMesh shaken_ellipsoid()
{
    TriangleMesh mesh = shaken_sphere();
    transform(mesh, {{{Vec3{3, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {}});
    return mesh;
}

TEST(Relaxation, no_more_faces_lie_beyond_the_bound_than_did)
{
    const auto reference = std::make_shared<const MeshDistance>(
        []
        {
            TriangleMesh fine = icosphere(6, 10.0);
            transform(fine, {{{Vec3{3, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {}});
            return fine;
        }());
    const TriangleMesh before = shaken_ellipsoid();
    for (const double bound : {0.05, 0.5})
    {
        const BoundingSurface surface{projection_onto(reference), face_distance_to(reference), bound};
        const RelaxationResult result = relax(before, surface);
        EXPECT_TRUE(is_closed_manifold(result.mesh));
        EXPECT_LE(count_beyond(result.mesh, surface), count_beyond(before, surface));
        EXPECT_GE(measure_angles(result.mesh).min_deg, measure_angles(before).min_deg);
        EXPECT_TRUE(self_intersections(result.mesh).empty());
        EXPECT_EQ(result.short_faces.all(), count_faces_below_angle(result.mesh, 33.0));
    }
}

//! As where refinement ended before it came to the surface.
BoundingSurface no_surface_near(double max_distance)
{
    return {[](const Point3&) { return std::optional<NearestPoint>(); },
            [](const Point3&, const Point3&, const Point3&)
            { return std::numeric_limits<double>::infinity(); },
            max_distance};
}

TEST(Relaxation, angles_rise_where_there_is_no_surface_near_and_the_mesh_stays_where_it_was)
{
    constexpr double kBound = 0.3;
    TriangleMesh before = icosphere(2, 10.0);
    Random random(1);
    for (Point3& p : before.vertices)
        p = 10.0 * normalized(p + Vec3{random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8),
                                       random.uniform(-0.8, 0.8)});
    const std::size_t short_before = count_faces_below_angle(before, 33.0);
    ASSERT_GT(short_before, 10U);

    const RelaxationResult result = relax(before, no_surface_near(kBound));

    EXPECT_GE(measure_angles(result.mesh).min_deg, 33.0) << "of " << short_before;
    EXPECT_TRUE(is_closed_manifold(result.mesh));
    EXPECT_EQ(euler_characteristic(result.mesh), 2);
    EXPECT_TRUE(self_intersections(result.mesh).empty());
    EXPECT_LE(result.mesh.faces.size(), before.faces.size());    // all of them beyond the bound
    EXPECT_LE(deviation(before, result.mesh).max, 4.5 * kBound); // asked at fewer points than are measured
}

TEST(Relaxation, options_out_of_range_are_refused)
{
    EXPECT_THROW(relaxed(sample::tetrahedron(), 0.0), UsageError);
}

} // namespace
} // namespace voroprobe
