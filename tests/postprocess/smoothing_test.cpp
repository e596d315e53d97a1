#include <cmath>
#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
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
    const TriangleMesh result = smoothed(noisy, 10);
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
    const TriangleMesh result = smoothed(mesh, 5);
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

} // namespace
} // namespace voroprobe
