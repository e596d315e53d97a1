#include "volume/spread_crossings.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

constexpr double kRadius = 8.3;
constexpr Point3 kCenter{12.1, 11.7, 12.4};

//! A ball with a hollow: two surfaces.
LevelFunction hollow_ball()
{
    return [](const Point3& p)
    {
        const double r = distance(p, kCenter);
        return std::min(kRadius - r, r - 0.5 * kRadius);
    };
}

struct Scan
{
    std::unique_ptr<HeightField> field;
    std::unique_ptr<Inventory> inventory;
};

Scan scan_of(const LevelFunction& level, const std::array<std::size_t, 3>& size, const Vec3& spacing)
{
    const auto volume = std::make_shared<Volume>(sample_volume(level, size, spacing));
    auto field = make_height_field(level_volume(volume, 0.0));
    auto inventory = std::make_unique<Inventory>(*field, 1);
    return {std::move(field), std::move(inventory)};
}

TEST(SpreadCrossings, lie_on_the_surface_they_name)
{
    const Scan scan = scan_of(hollow_ball(), {25, 25, 25}, {1, 1, 1});
    ASSERT_EQ(scan.inventory->surfaces().size(), 2U);
    std::set<SurfaceId> met;
    for (const SurfacePoint& at : spread_crossings(*scan.field, *scan.inventory, 3.0, 1))
    {
        const bool cavity = scan.inventory->surfaces()[static_cast<std::size_t>(at.surface)].cavity;
        EXPECT_NEAR(distance(at.point, kCenter), cavity ? 0.5 * kRadius : kRadius, 0.1);
        met.insert(at.surface);
    }
    EXPECT_EQ(met.size(), 2U);
}

TEST(SpreadCrossings, leave_no_part_of_a_surface_out)
{
    constexpr double kSide = 3.0;
    const Scan scan = scan_of(hollow_ball(), {25, 25, 13}, {1, 1, 2});
    const auto spread = spread_crossings(*scan.field, *scan.inventory, kSide, 1);
    const std::vector<SurfaceId> surfaces{0, 1};
    const auto all = grid_crossings(*scan.field, *scan.inventory, surfaces, 100'000);
    EXPECT_LT(spread.size(), (all[0].size() + all[1].size()) / 4);
    for (const SurfaceId surface : surfaces)
        for (const Point3& p : all[static_cast<std::size_t>(surface)])
        {
            // Two points of a cube, and of grid cells whose lowest corners lie in it.
            const bool near = std::any_of(spread.begin(), spread.end(),
                                          [&](const SurfacePoint& at) {
                                              return at.surface == surface &&
                                                     distance(at.point, p) <= std::sqrt(3.0) * (kSide + 2.0);
                                          });
            EXPECT_TRUE(near) << p.x << ' ' << p.y << ' ' << p.z;
        }
}

TEST(SpreadCrossings, are_the_same_for_any_number_of_threads)
{
    const Scan scan = scan_of(hollow_ball(), {25, 25, 50}, {1, 1, 0.5});
    const auto as_numbers = [&](std::size_t threads)
    {
        std::vector<double> numbers;
        for (const SurfacePoint& at : spread_crossings(*scan.field, *scan.inventory, 2.0, threads))
            numbers.insert(numbers.end(),
                           {static_cast<double>(at.surface), at.point.x, at.point.y, at.point.z});
        return numbers;
    };
    EXPECT_EQ(as_numbers(1), as_numbers(2));
    EXPECT_EQ(as_numbers(1), as_numbers(0));
}

} // namespace
} // namespace voroprobe
