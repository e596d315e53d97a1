#include "certificate/face_tree.h"

#include <algorithm>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "certificate/mesh_sides.h"
#include "certificate/space_order.h"
#include "geometry/point_triangle.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

Point3 random_point(Random& random, double half_width)
{
    const auto coordinate = [&] { return half_width * (2.0 * random.uniform() - 1.0); };
    return {coordinate(), coordinate(), coordinate()};
}

//! Faces of all sizes all over a cube, overlapping, from half of them flat.
TriangleMesh scattered_faces(std::size_t count)
{
    Random random(1);
    TriangleMesh mesh;
    for (std::uint32_t f = 0; f < count; ++f)
    {
        const Point3 place = random_point(random, 1.0);
        const double size = 0.5 * random.uniform();
        for (int i = 0; i < 3; ++i)
            mesh.vertices.push_back(f % 2 == 0 && i == 2 ? mesh.vertices.back()
                                                         : place + random_point(random, size));
        mesh.faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    }
    return mesh;
}

Box3 box_of(const TriangleMesh& mesh, std::uint32_t f)
{
    Box3 box;
    for (const std::uint32_t v : mesh.faces[f])
        box.include(mesh.vertices[v]);
    return box;
}

TEST(FaceTree, tells_the_distance_that_the_nearest_of_all_faces_has)
{
    for (const std::size_t faces : {1, 4, 5, 17, 300})
    {
        const TriangleMesh mesh = scattered_faces(faces);
        const FaceTree tree(mesh);
        Random random(2);
        for (int i = 0; i < 200; ++i)
        {
            const Point3 p = random_point(random, 2.0);
            double squared = std::numeric_limits<double>::infinity();
            for (const TriangleMesh::Face& face : mesh.faces)
                squared = std::min(
                    squared, squared_distance_to_triangle(
                                 p, {mesh.corner(face, 0), mesh.corner(face, 1), mesh.corner(face, 2)}));
            ASSERT_DOUBLE_EQ(tree.distance(p), std::sqrt(squared));
        }
    }
}

TEST(FaceTree, tells_every_pair_of_faces_with_meeting_boxes_once)
{
    for (const std::size_t faces : {0, 1, 2, 5, 16, 17, 1500})
    {
        const TriangleMesh mesh = scattered_faces(faces);
        std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
        for (std::uint32_t f = 0; f < faces; ++f)
            for (std::uint32_t g = f + 1; g < faces; ++g)
                if (!intersection(box_of(mesh, f), box_of(mesh, g)).empty())
                    expected.emplace(f, g);

        const FaceTree tree(mesh);
        std::set<std::pair<std::uint32_t, std::uint32_t>> found;
        std::size_t told = 0;
        for (std::size_t block = 0; block < tree.block_count(); ++block)
            tree.for_each_meeting_pair(block,
                                       [&](std::uint32_t f, std::uint32_t g)
                                       {
                                           found.insert(std::minmax(f, g));
                                           ++told;
                                       });
        EXPECT_EQ(found, expected);
        EXPECT_EQ(told, expected.size());
    }
}

TEST(FaceTree, of_a_mesh_without_faces_is_infinitely_far_from_everywhere)
{
    const TriangleMesh nothing;
    EXPECT_EQ(FaceTree(nothing).distance({1, 2, 3}), std::numeric_limits<double>::infinity());
}

TEST(SpaceOrder, halves_every_aligned_run_by_a_plane_across_an_axis)
{
    Random random(3);
    std::vector<Point3> points;
    for (int i = 0; i < 1000; ++i)
        points.push_back(random_point(random, 1.0));
    const std::vector<std::uint32_t> order = order_in_space(points);
    std::vector<std::uint32_t> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    for (std::uint32_t i = 0; i < sorted.size(); ++i)
        ASSERT_EQ(sorted[i], i);

    for (std::size_t length = 8; length <= 512; length *= 2)
        for (std::size_t begin = 0; begin + length <= order.size(); begin += length)
        {
            Box3 first;
            Box3 second;
            for (std::size_t i = begin; i < begin + length; ++i)
                (i < begin + length / 2 ? first : second).include(points[order[i]]);
            const Box3 common = intersection(first, second);
            EXPECT_TRUE(common.empty() ||
                        std::min({common.extent().x, common.extent().y, common.extent().z}) < 1e-6);
        }
}

TEST(EnclosedBy, tells_the_inside_of_a_torus_from_its_hole)
{
    const TriangleMesh torus = sample::torus(48, 24);
    const FaceTree tree(torus);
    Random random(4);
    std::vector<Point3> points;
    for (int i = 0; i < 500; ++i)
        points.push_back(random_point(random, 0.6 * bounding_box(torus).diagonal()));
    const std::vector<std::uint8_t> enclosed = enclosed_by(tree, points);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        double solid_angle = 0.0; // Source: van Oosterom & Strackee 1983
        for (const TriangleMesh::Face& face : torus.faces)
        {
            const Vec3 a = torus.corner(face, 0) - points[i];
            const Vec3 b = torus.corner(face, 1) - points[i];
            const Vec3 c = torus.corner(face, 2) - points[i];
            solid_angle +=
                2.0 * std::atan2(dot(a, cross(b, c)), norm(a) * norm(b) * norm(c) + dot(a, b) * norm(c) +
                                                          dot(b, c) * norm(a) + dot(c, a) * norm(b));
        }
        EXPECT_EQ(enclosed[i] != 0, std::abs(solid_angle) > 6.0) << "point " << i;
    }
}

} // namespace
} // namespace voroprobe
