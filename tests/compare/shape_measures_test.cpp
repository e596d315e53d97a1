#include "compare/shape_measures.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"

namespace voroprobe
{

namespace
{

//! The smallest angle of a face by the law of cosines, degrees.
double smallest_angle(const TriangleMesh& mesh, const TriangleMesh::Face& face)
{
    double smallest = 180.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const double a = distance(mesh.corner(face, (i + 1) % 3), mesh.corner(face, (i + 2) % 3));
        const double b = distance(mesh.corner(face, i), mesh.corner(face, (i + 1) % 3));
        const double c = distance(mesh.corner(face, i), mesh.corner(face, (i + 2) % 3));
        smallest =
            std::min(smallest, std::acos((b * b + c * c - a * a) / (2 * b * c)) * 180.0 / std::numbers::pi);
    }
    return smallest;
}

std::size_t sum(std::span<const std::size_t> counts, std::size_t first, std::size_t last)
{
    return std::accumulate(counts.begin() + static_cast<std::ptrdiff_t>(first),
                           counts.begin() + static_cast<std::ptrdiff_t>(last), std::size_t{0});
}

TEST(ShapeMeasures, equilateral_triangles_have_the_best_ratios)
{
    const ShapeMeasures shapes = measure_shapes(sample::icosahedron());
    EXPECT_NEAR(shapes.mean_radius_edge_ratio, 1.0 / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(shapes.max_aspect_ratio, 1.0, 1e-12);
    EXPECT_NEAR(shapes.mean_edge_length, 2.0, 1e-12);
    EXPECT_EQ(shapes.vertices_by_valence[5], 12U);
}

TEST(ShapeMeasures, the_radius_edge_ratio_is_that_of_the_smallest_angle)
{
    TriangleMesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {0.2, 0.3, 0}}, .faces = {{0, 1, 2}}};
    const double angle = smallest_angle(mesh, mesh.faces.front()) * std::numbers::pi / 180.0;
    EXPECT_NEAR(measure_shapes(mesh).max_radius_edge_ratio, 1.0 / (2.0 * std::sin(angle)), 1e-12);
}

TEST(ShapeMeasures, shares_of_angles_are_those_of_a_direct_count)
{
    const TriangleMesh mesh = sample::torus(60, 9);
    const ShapeMeasures shapes = measure_shapes(mesh);
    for (const std::size_t bound : {10U, 20U, 30U, 40U})
    {
        std::size_t below = 0;
        for (const TriangleMesh::Face& face : mesh.faces)
            below += smallest_angle(mesh, face) < static_cast<double>(bound) ? 1 : 0;
        EXPECT_EQ(sum(shapes.smallest_angles.counts(), 0, bound), below) << bound;
    }
    EXPECT_EQ(sum(shapes.angles.counts(), 0, shapes.angles.counts().size()), 3 * mesh.faces.size());
}

TEST(ShapeMeasures, faces_without_area_are_counted_and_left_out)
{
    TriangleMesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}},
                      .faces = {{0, 1, 2}, {0, 1, 3}}};
    const ShapeMeasures shapes = measure_shapes(mesh);
    EXPECT_EQ(shapes.flat_faces, 1U);
    EXPECT_TRUE(std::isfinite(shapes.mean_aspect_ratio));
}

} // namespace

} // namespace voroprobe
