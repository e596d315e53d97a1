#pragma once

#include <gtest/gtest.h>

#include "oracles/surface_oracle.h"
#include "support/random.h"

namespace voroprobe
{

inline Point3 random_point(Random& random, const Box3& box)
{
    return {random.uniform(box.min.x, box.max.x), random.uniform(box.min.y, box.max.y),
            random.uniform(box.min.z, box.max.z)};
}

inline Segment3 random_segment(Random& random, const Box3& box)
{
    const Point3 source = random_point(random, box);
    return {source, random_point(random, box)};
}

//! What surface_oracle.h promises of the crossings of any segment: in order, on the segment, odd in number
//! exactly where the ends lie on different sides.
inline testing::AssertionResult keeps_the_laws(const SurfaceOracle& oracle, const Segment3& segment,
                                               const std::vector<Crossing>& crossings)
{
    const auto described = [&]
    {
        return testing::AssertionFailure()
               << std::hexfloat << "segment (" << segment.source.x << ", " << segment.source.y << ", "
               << segment.source.z << ") to (" << segment.target.x << ", " << segment.target.y << ", "
               << segment.target.z << "), " << crossings.size() << " crossings: ";
    };
    const bool from_inside = is_inside(oracle.region(segment.source));
    const bool to_inside = is_inside(oracle.region(segment.target));
    if ((crossings.size() % 2 == 1) != (from_inside != to_inside))
        return described() << "parity, from inside " << from_inside << ", to inside " << to_inside;
    double last = 0.0;
    for (const Crossing& crossing : crossings)
    {
        if (!(crossing.t >= last && crossing.t <= 1.0))
            return described() << "parameter " << crossing.t << " after " << last;
        if (crossing.point != segment.at(crossing.t))
            return described() << "point is not at its parameter";
        last = crossing.t;
    }
    return testing::AssertionSuccess();
}

//! Asserts the laws on `count` segments whose ends may lie beyond the domain, and that a box around each
//! crossing may cross.
inline void expect_laws_on_random_segments(const SurfaceOracle& oracle, std::uint64_t seed, std::size_t count)
{
    Random random(seed);
    const Box3 reach = oracle.domain().expanded(0.2 * oracle.domain().diagonal());
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i < count; ++i)
    {
        const Segment3 segment = random_segment(random, reach);
        oracle.find_crossings(segment, crossings);
        ASSERT_TRUE(keeps_the_laws(oracle, segment, crossings));
        for (const Crossing& crossing : crossings)
        {
            Box3 around{crossing.point, crossing.point};
            ASSERT_TRUE(oracle.may_cross(around.expanded(1e-6 * reach.diagonal())));
        }
    }
}

//! Asserts on `count` segments what an inventory adds: from end to end the region changes at crossings only,
//! to one behind a surface, which is that of the crossing.
inline void expect_region_laws_on_random_segments(const SurfaceOracle& oracle, std::uint64_t seed,
                                                  std::size_t count)
{
    constexpr double kNearest = 1e-9; // of two crossings: nearer ones may be in each other's rounding
    Random random(seed);
    const Box3 reach = oracle.domain().expanded(0.2 * oracle.domain().diagonal());
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i < count; ++i)
    {
        const Segment3 segment = random_segment(random, reach);
        oracle.find_crossings(segment, crossings);
        Region region = oracle.region(segment.source);
        double last = 0.0;
        for (std::size_t c = 0; c < crossings.size(); ++c)
        {
            const double next = c + 1 < crossings.size() ? crossings[c + 1].t : 1.0;
            if (crossings[c].t - last < kNearest || next - crossings[c].t < kNearest)
                break;
            const Region before = oracle.region(segment.at(0.5 * (last + crossings[c].t)));
            ASSERT_EQ(before, region);
            region = oracle.region(segment.at(0.5 * (crossings[c].t + next)));
            const SurfaceId surface = oracle.surface_between(before, region);
            ASSERT_NE(surface, kNoSurface);
            ASSERT_EQ(oracle.surface_at(crossings[c].point), surface);
            ASSERT_TRUE(oracle.surface_around(before) == surface || oracle.surface_around(region) == surface);
            last = crossings[c].t;
        }
        ASSERT_TRUE(!crossings.empty() || oracle.region(segment.target) == region);
    }
}

} // namespace voroprobe
