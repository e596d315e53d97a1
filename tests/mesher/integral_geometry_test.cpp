#include "integral_geometry.h"

#include <numbers>

#include <gtest/gtest.h>

#include "oracles/implicit_oracle.h"
#include "surface_distance.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

using std::numbers::pi;

constexpr double kRelativeError = 0.002; // of measures with 200 * 40^2 lines

TEST(IntegralGeometry, a_torus_has_its_area_volume_and_curvature)
{
    const LevelFunction torus = torus_phantom({1, 2, 3}, 8.0, 3.0);
    const ImplicitOracle oracle(torus, {{-11, -10, -1}, {13, 14, 7}}, 1.0, 1e-3);
    const SurfaceMeasures measures = measure_with_lines(oracle, 200, 40);
    EXPECT_NEAR(measures.area / (4.0 * pi * pi * 24.0), 1.0, kRelativeError);
    EXPECT_NEAR(measures.volume / (2.0 * pi * pi * 72.0), 1.0, kRelativeError);

    // 1 / 3 around the tube, up to 1 / 5 around the hole.
    Random random(1);
    EXPECT_NEAR(largest_curvature(torus, sample_surface(oracle, 10'000, random), 1e-3),
                std::hypot(1.0 / 3.0, 1.0 / 5.0), 1e-3);
}

} // namespace
} // namespace voroprobe
