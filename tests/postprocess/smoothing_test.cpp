#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "certificate/self_intersections.h"
#include "mesh/measures.h"
#include "postprocess/smoothing.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

TEST(Smoothing, noise_goes_and_the_volume_stays)
{
    const TriangleMesh clean = sample::icosphere(4, 10.0);
    TriangleMesh noisy = clean;
    Random random(3);
    for (Point3& p : noisy.vertices)
        p = random.uniform(0.98, 1.02) * p;
    const TriangleMesh result = smooth(noisy, 10).mesh;
    const auto roughness = [](const TriangleMesh& mesh)
    {
        double sum = 0.0;
        for (const Point3& p : mesh.vertices)
            sum += std::abs(norm(p) - 10.0);
        return sum;
    };
    EXPECT_LT(roughness(result), 0.4 * roughness(noisy));
    EXPECT_NEAR(enclosed_volume(result) / enclosed_volume(clean), 1.0, 0.01);
    EXPECT_EQ(result.faces, noisy.faces);
}

TEST(Smoothing, an_open_border_stays)
{
    TriangleMesh mesh = sample::icosphere(3);
    mesh.faces.resize(mesh.faces.size() / 2);
    const TriangleMesh result = smooth(mesh, 5).mesh;
    std::vector<int> balance(mesh.vertices.size(), 0);
    for (const auto& face : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i)
            balance[face[i]] += static_cast<int>(face[(i + 1) % 3]) - static_cast<int>(face[(i + 2) % 3]);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (balance[v] != 0)
        {
            EXPECT_EQ(result.vertices[v], mesh.vertices[v]);
        }
}

//! A ball with a dent of many faces, and in it a coarse one that has room for the dent in a dent of few
//! faces, which smoothing flattens.
TriangleMesh dented_balls()
{
    TriangleMesh outer = sample::icosphere(4, 9.0);
    const Vec3 dent = normalized(outer.vertices[0]);
    for (Point3& p : outer.vertices)
    {
        const double angle = std::acos(std::clamp(dot(p, dent) / 9.0, -1.0, 1.0));
        p = (1.0 - std::exp(-angle * angle / 0.04) / 3.0) * p;
    }
    TriangleMesh inner = sample::icosphere(1, 8.0);
    inner.vertices[0] = 0.375 * inner.vertices[0];
    const auto count = static_cast<std::uint32_t>(outer.vertices.size());
    outer.vertices.insert(outer.vertices.end(), inner.vertices.begin(), inner.vertices.end());
    for (const TriangleMesh::Face& face : inner.faces)
        outer.faces.push_back({face[0] + count, face[2] + count, face[1] + count});
    return outer;
}

TEST(Smoothing, faces_do_not_come_to_cross)
{
    const TriangleMesh mesh = dented_balls();
    ASSERT_TRUE(self_intersections(mesh).empty());
    const SmoothingResult result = smooth(mesh, 8);
    EXPECT_TRUE(self_intersections(result.mesh).empty());
    EXPECT_GT(result.vertices_held, 0U);
    EXPECT_LT(result.vertices_held, mesh.vertices.size() / 4);
}

} // namespace
} // namespace voroprobe
