#include "volume/phantoms.h"

#include <cmath>
#include <numbers>

#include "oracle_laws.h"

namespace voroprobe
{
namespace
{

using std::numbers::pi;

//! Volume inside a level function by midpoints of n^3 boxes.
double enclosed_volume(const LevelFunction& function, const Box3& box, int n)
{
    const Vec3 step = box.extent() / n;
    std::size_t inside = 0;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                inside += function(box.min +
                                   Vec3{(i + 0.5) * step.x, (j + 0.5) * step.y, (k + 0.5) * step.z}) >= 0.0;
    return static_cast<double>(inside) * step.x * step.y * step.z;
}

//! Largest slope seen over short random segments in the box; a lower estimate of the Lipschitz bound.
double largest_slope(const LevelFunction& function, const Box3& box)
{
    Random random(5);
    double slope = 0.0;
    for (int i = 0; i < 100'000; ++i)
    {
        const Point3 p = random_point(random, box);
        const Point3 q = p + 1e-4 * normalized(random_point(random, {{-1, -1, -1}, {1, 1, 1}}));
        slope = std::max(slope, std::abs(function(p) - function(q)) / distance(p, q));
    }
    return slope;
}

TEST(Phantoms, enclose_their_volume)
{
    const Box3 cube{{-3, -3, -3}, {3, 3, 3}};
    EXPECT_NEAR(enclosed_volume(sphere_phantom({0, 0, 0}, 2.5), cube, 100) /
                    (4.0 / 3.0 * pi * 2.5 * 2.5 * 2.5),
                1.0, 0.01);
    EXPECT_NEAR(enclosed_volume(torus_phantom({0, 0, 0}, 2.0, 0.8), cube, 100) / (2.0 * pi * pi * 2.0 * 0.64),
                1.0, 0.01);
    EXPECT_NEAR(enclosed_volume(nested_shells_phantom({0, 0, 0}, {2.5, 2.0, 1.0}), cube, 100) /
                    (4.0 / 3.0 * pi * (15.625 - 8.0 + 1.0)),
                1.0, 0.01);
}

TEST(Phantoms, keep_their_slope_bounds)
{
    const Box3 cube{{-3, -3, -3}, {3, 3, 3}};
    const double rounding = 1.0 + 1e-6;
    EXPECT_LE(largest_slope(sphere_phantom({0, 0, 0}, 2.5), cube), rounding);
    EXPECT_LE(largest_slope(torus_phantom({0, 0, 0}, 2.0, 0.8), cube), rounding);
    EXPECT_LE(largest_slope(nested_shells_phantom({0, 0, 0}, {2.5, 2.0, 1.0}), cube), rounding);
    EXPECT_LE(largest_slope(double_torus_phantom({0, 0, 0}, 1.0), {{-1.2, -0.8, -0.5}, {1.2, 0.8, 0.5}}),
              13.0);
    EXPECT_LE(largest_slope(marschner_lobb_phantom({0, 0, 0}, 1.0), {{-1, -1, -1}, {1, 1, 1}}), 6.0);
}

TEST(Phantoms, the_double_torus_has_two_holes_and_stays_in_its_box)
{
    const auto torus = double_torus_phantom({5, 0, 0}, 2.0);
    EXPECT_GE(torus({5, 0, 0}), 0.0);
    EXPECT_LT(torus({5 + std::sqrt(2.0), 0, 0}), 0.0);
    EXPECT_LT(torus({5 - std::sqrt(2.0), 0, 0}), 0.0);
    EXPECT_LT(torus({5 + 2.1, 0, 0}), 0.0);
    EXPECT_LT(torus({5 + std::sqrt(2.0), 1.2, 0}), 0.0);
    EXPECT_LT(torus({5, 0, 0.2001}), 0.0);
}

TEST(Phantoms, samples_lie_where_the_grid_says)
{
    const auto coordinates = [](const Point3& p) { return p.x + 100.0 * p.y + 10'000.0 * p.z; };
    const Volume volume = sample_volume(coordinates, {3, 4, 5}, {0.5, 1.0, 2.0});
    EXPECT_EQ(volume.geometry.sample_count(), 60U);
    const auto& samples = std::get<std::vector<float>>(volume.samples);
    ASSERT_EQ(samples.size(), 60U);
    EXPECT_EQ(samples[2 + 3 * (3 + 4 * 4)], 1.0F + 300.0F + 80'000.0F);
    EXPECT_EQ(volume.geometry.source_index_from_grid * (Point3{1, 3, 8}), (Point3{2, 3, 4}));
}

} // namespace
} // namespace voroprobe
