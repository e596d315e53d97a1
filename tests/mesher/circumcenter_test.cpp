#include "mesher/circumcenter.h"

#include <array>
#include <cmath>
#include <optional>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include "support/random.h"

namespace voroprobe
{
namespace
{

using Exact = CGAL::Exact_rational;
using ExactVector = CGAL::Simple_cartesian<Exact>::Vector_3;

//! Of the radius. The header promises about 1e-9; rounding costs at most some ten units in the last place
//! over the sliver ratio of 1e-7.
constexpr double kPromised = 1e-8;

//! Cramer's rule for 2 (p_i - p_0) . x = |p_i - p_0|^2, in rational numbers; nullopt for coplanar points.
std::optional<Point3> reference(const std::array<Point3, 4>& corners)
{
    std::array<ExactVector, 3> edge;
    for (std::size_t i = 0; i < 3; ++i)
        edge[i] = ExactVector(Exact(corners[i + 1].x) - Exact(corners[0].x),
                              Exact(corners[i + 1].y) - Exact(corners[0].y),
                              Exact(corners[i + 1].z) - Exact(corners[0].z));
    const Exact determinant = edge[0] * CGAL::cross_product(edge[1], edge[2]);
    if (determinant == 0)
        return std::nullopt;
    const ExactVector offset = (edge[0].squared_length() * CGAL::cross_product(edge[1], edge[2]) +
                                edge[1].squared_length() * CGAL::cross_product(edge[2], edge[0]) +
                                edge[2].squared_length() * CGAL::cross_product(edge[0], edge[1])) /
                               (2 * determinant);
    return Point3{CGAL::to_double(Exact(corners[0].x) + offset.x()),
                  CGAL::to_double(Exact(corners[0].y) + offset.y()),
                  CGAL::to_double(Exact(corners[0].z) + offset.z())};
}

//! Error over radius; 0 for coplanar points, which have no circumcenter.
double relative_error(const std::array<Point3, 4>& corners)
{
    const auto exact = reference(corners);
    return exact ? distance(circumcenter(corners), *exact) / distance(*exact, corners[0]) : 0.0;
}

Point3 random_point(Random& random, const Point3& around)
{
    return around + Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(Circumcenter, of_a_corner_of_a_cube_is_its_middle)
{
    EXPECT_EQ(circumcenter({Point3{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}), Point3(1, 1, 1));
}

TEST(Circumcenter, of_random_tetrahedra_is_exact_to_eight_digits)
{
    Random random(1);
    for (int i = 0; i < 5000; ++i)
    {
        const Point3 around{100, -200, 50};
        ASSERT_LE(relative_error({random_point(random, around), random_point(random, around),
                                  random_point(random, around), random_point(random, around)}),
                  kPromised);
    }
}

TEST(Circumcenter, of_slivers_is_exact_to_eight_digits)
{
    // Four points near a circle, the last ever closer to the plane of the others.
    Random random(2);
    for (int i = 0; i < 5000; ++i)
    {
        std::array<Point3, 4> corners;
        const double height = std::pow(10.0, random.uniform(-16.0, -1.0));
        for (Point3& corner : corners)
        {
            const double angle = random.uniform(0.0, 6.28);
            corner =
                Point3{30.0 + std::cos(angle), -20.0 + std::sin(angle), 7.0 + height * random.uniform(-1, 1)};
        }
        ASSERT_LE(relative_error(corners), kPromised) << "height " << height;
    }
}

TEST(Circumcenter, of_needles_is_exact_to_eight_digits)
{
    Random random(3);
    for (int i = 0; i < 5000; ++i)
    {
        const double width = std::pow(10.0, random.uniform(-12.0, -1.0));
        std::array<Point3, 4> corners;
        for (Point3& corner : corners)
            corner = {width * random.uniform(-1, 1), random.uniform(-1, 1), width * random.uniform(-1, 1)};
        ASSERT_LE(relative_error(corners), kPromised) << "width " << width;
    }
}

} // namespace
} // namespace voroprobe
