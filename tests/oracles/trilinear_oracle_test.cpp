#include "oracles/trilinear_oracle.h"

#include <cmath>
#include <limits>

#include "concurrent_queries.h"
#include "oracle_laws.h"
#include "support/error.h"
#include "trilinear_reference.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

//! How far two crossings found in different ways may lie apart, and how near a pair has to be for one way to
//! pass over it; grid edges.
constexpr double kPositionTolerance = 1e-6;

Volume volume_of(const std::array<std::size_t, 3>& size, const Vec3& spacing, SampleArray samples)
{
    Volume volume = sample_volume([](const Point3&) { return 0.0; }, size, spacing);
    volume.samples = std::move(samples);
    return volume;
}

//! Uniform samples in [-1, 1): surface nearly everywhere, most grid faces ambiguous.
Volume random_float_volume(std::uint64_t seed, const Vec3& spacing)
{
    Random random(seed);
    std::vector<float> samples(std::size_t{13} * 11 * 12);
    for (float& sample : samples)
        sample = static_cast<float>(random.uniform(-1.0, 1.0));
    return volume_of({13, 11, 12}, spacing, samples);
}

//! Whole samples 0 to 4.
template <class Sample>
Volume random_integer_volume(std::uint64_t seed, const Vec3& spacing)
{
    Random random(seed);
    std::vector<Sample> samples(std::size_t{13} * 11 * 12);
    for (Sample& sample : samples)
        sample = static_cast<Sample>(random.below(5));
    return volume_of({13, 11, 12}, spacing, samples);
}

enum class Kind
{
    kLong,
    kShort,
    kAxisParallel,
    kThroughLattice, //!< ends on multiples of half a grid edge
    kFromOutside
};

Point3 lattice_point(Random& random, const Volume& volume)
{
    Point3 p;
    for (std::size_t axis = 0; axis < 3; ++axis)
        p[axis] = 0.5 * volume.geometry.spacing[axis] *
                  static_cast<double>(random.below(2 * volume.geometry.size[axis] - 1));
    return p;
}

Segment3 segment_of(Kind kind, Random& random, const Volume& volume)
{
    const Box3 box = volume.geometry.grid_box();
    if (kind == Kind::kLong)
        return random_segment(random, box);
    if (kind == Kind::kFromOutside)
        return random_segment(random, box.expanded(0.3 * box.diagonal()));
    if (kind == Kind::kThroughLattice)
    {
        const Point3 source = lattice_point(random, volume);
        return {source, lattice_point(random, volume)};
    }
    const Point3 source = random.below(2) == 0 ? random_point(random, box) : lattice_point(random, volume);
    if (kind == Kind::kShort)
        return {source, source + random_point(random, Box3{{0, 0, 0}, {0, 0, 0}}.expanded(1.5))};
    Point3 target = source;
    const std::size_t axis = random.below(3);
    target[axis] = random.uniform(box.min[axis], box.max[axis]);
    return {source, target};
}

//! Same crossings up to the tolerance, pairs nearer than it passed over by either.
bool same_crossings(const std::vector<Crossing>& crossings, const std::vector<double>& expected,
                    double tolerance)
{
    std::size_t c = 0;
    std::size_t e = 0;
    const auto pair_at = [&](auto parameter, std::size_t i, std::size_t count)
    { return i + 1 < count && parameter(i + 1) - parameter(i) < tolerance; };
    const auto found = [&](std::size_t i) { return crossings[i].t; };
    const auto wanted = [&](std::size_t i) { return expected[i]; };
    while (c < crossings.size() || e < expected.size())
    {
        if (c < crossings.size() && e < expected.size() && std::abs(found(c) - wanted(e)) < tolerance)
        {
            ++c;
            ++e;
        }
        else if (pair_at(found, c, crossings.size()))
            c += 2;
        else if (pair_at(wanted, e, expected.size()))
            e += 2;
        else
            return false;
    }
    return true;
}

double index_length(const Segment3& segment, const Vec3& spacing)
{
    const Vec3 d = segment.target - segment.source;
    return norm(Vec3{d.x / spacing.x, d.y / spacing.y, d.z / spacing.z});
}

//! Compares with the reference; counts segments where the two lists differ by a pair nearer than the
//! tolerance.
void expect_as_reference(const Volume& volume, double isovalue, InsideIs inside, Kind kind, std::size_t count)
{
    const auto oracle = make_trilinear_oracle(std::make_shared<Volume>(volume), isovalue, inside);
    TrilinearReference reference(volume, isovalue, inside);
    Random random(7 + static_cast<std::uint64_t>(kind));
    std::vector<Crossing> crossings;
    std::size_t pairs_apart = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
        const Segment3 segment = segment_of(kind, random, volume);
        oracle->find_crossings(segment, crossings);
        const auto expected = reference.crossings(segment);
        const double length = index_length(segment, volume.geometry.spacing);
        ASSERT_TRUE(keeps_the_laws(*oracle, segment, crossings));
        ASSERT_TRUE(
            same_crossings(crossings, expected, kPositionTolerance / std::max(length, kPositionTolerance)))
            << "segment " << i << ", " << crossings.size() << " crossings, expected " << expected.size();
        pairs_apart += crossings.size() != expected.size();
    }
    EXPECT_LE(pairs_apart, count / 10'000)
        << "pairs of crossings nearer than " << kPositionTolerance << " grid edges";
}

struct ReferenceCase
{
    const char* name;
    Kind kind;
    std::size_t count;
};

class TrilinearOracleAgainstReference : public testing::TestWithParam<ReferenceCase>
{
};

TEST_P(TrilinearOracleAgainstReference, random_samples)
{
    const auto [name, kind, count] = GetParam();
    expect_as_reference(random_float_volume(1, {1, 1, 1}), 0.1, InsideIs::kAbove, kind, count);
    expect_as_reference(random_float_volume(2, {0.7, 1.0, 2.3}), -0.2, InsideIs::kBelow, kind, count);
}

TEST_P(TrilinearOracleAgainstReference, whole_samples_that_equal_the_isovalue)
{
    const auto [name, kind, count] = GetParam();
    expect_as_reference(random_integer_volume<std::uint8_t>(3, {1, 1, 1}), 2.0, InsideIs::kAbove, kind,
                        count);
    expect_as_reference(random_integer_volume<std::int16_t>(4, {0.7, 1.0, 2.3}), 2.0, InsideIs::kBelow, kind,
                        count);
}

INSTANTIATE_TEST_SUITE_P(, TrilinearOracleAgainstReference,
                         testing::Values(ReferenceCase{"long_segments", Kind::kLong, 25'000},
                                         ReferenceCase{"short_segments", Kind::kShort, 125'000},
                                         ReferenceCase{"axis_parallel_segments", Kind::kAxisParallel, 40'000},
                                         ReferenceCase{"segments_through_lattice_points",
                                                       Kind::kThroughLattice, 35'000},
                                         ReferenceCase{"segments_from_outside", Kind::kFromOutside, 25'000}),
                         [](const auto& test) { return std::string(test.param.name); });

std::unique_ptr<SurfaceOracle> oracle_of(Volume volume, double isovalue, InsideIs inside = InsideIs::kAbove)
{
    return make_trilinear_oracle(std::make_shared<Volume>(std::move(volume)), isovalue, inside);
}

std::vector<Crossing> crossings_of(const SurfaceOracle& oracle, const Segment3& segment)
{
    std::vector<Crossing> crossings;
    oracle.find_crossings(segment, crossings);
    return crossings;
}

//! x, y, z = 0, 1, ... of a small volume whose samples equal x.
Volume ramp(const std::array<std::size_t, 3>& size)
{
    return sample_volume([](const Point3& p) { return p.x; }, size, {1, 1, 1});
}

template <class Sample>
std::vector<Crossing> crossings_in_type(const Segment3& segment)
{
    const Vec3 spacing{0.9, 1.0, 1.7};
    return crossings_of(*oracle_of(random_integer_volume<Sample>(5, spacing), 2.5), segment);
}

TEST(TrilinearOracle, answers_do_not_depend_on_the_sample_type)
{
    Random random(6);
    for (int i = 0; i < 200; ++i)
    {
        const Segment3 segment = random_segment(random, Box3{{-2, -2, -2}, {13, 12, 20}});
        const auto expected = crossings_in_type<double>(segment);
        for (const auto& crossings :
             {crossings_in_type<std::uint8_t>(segment), crossings_in_type<std::int8_t>(segment),
              crossings_in_type<std::uint16_t>(segment), crossings_in_type<std::int16_t>(segment),
              crossings_in_type<std::int32_t>(segment), crossings_in_type<float>(segment)})
        {
            ASSERT_EQ(crossings.size(), expected.size());
            for (std::size_t c = 0; c < expected.size(); ++c)
                ASSERT_EQ(crossings[c].t, expected[c].t);
        }
    }
}

TEST(TrilinearOracle, a_plane_is_crossed_where_it_lies)
{
    const auto crossings = crossings_of(*oracle_of(ramp({6, 5, 4}), 2.25), {{0.5, 1, 1}, {4.5, 3, 2}});
    ASSERT_EQ(crossings.size(), 1U);
    EXPECT_NEAR(crossings[0].point.x, 2.25, 1e-12);
    EXPECT_FALSE(crossings[0].on_border);
}

TEST(TrilinearOracle, a_large_empty_volume_is_walked_to_the_far_side)
{
    // Two specks of one sample each, far from each other and from the segment's ends.
    Volume volume = sample_volume([](const Point3&) { return 0.0; }, {150, 40, 30}, {1, 1, 1});
    auto& samples = std::get<std::vector<float>>(volume.samples);
    samples[20 + 150 * (10 + 40 * 10)] = 1.0F;
    samples[130 + 150 * (30 + 40 * 20)] = 1.0F;
    const auto oracle = oracle_of(std::move(volume), 0.5);
    const Vec3 along{110, 20, 10};
    const Point3 first{20, 10, 10};
    const auto crossings = crossings_of(*oracle, {first - 0.2 * along, first + 1.4 * along});
    ASSERT_EQ(crossings.size(), 4U);
    EXPECT_LT(distance(0.5 * (crossings[0].point + crossings[1].point), first), 1e-9);
    EXPECT_LT(distance(0.5 * (crossings[2].point + crossings[3].point), first + along), 1e-9);
    EXPECT_TRUE(crossings_of(*oracle, {{0, 39, 0}, {149, 35, 3}}).empty());
}

TEST(TrilinearOracle, a_surface_that_meets_the_border_is_capped)
{
    const auto oracle = oracle_of(ramp({6, 5, 4}), 2.25);
    const auto crossings = crossings_of(*oracle, {{-10, 1, 1}, {10, 1, 1}});
    ASSERT_EQ(crossings.size(), 2U);
    EXPECT_FALSE(crossings[0].on_border);
    EXPECT_TRUE(crossings[1].on_border);
    EXPECT_NEAR(crossings[1].point.x, 5.0, 1e-12);
    EXPECT_EQ(oracle->region({5.0, 1, 1}), 1);
    EXPECT_EQ(oracle->region({5.0 + 1e-9, 1, 1}), kOuterRegion);
}

TEST(TrilinearOracle, samples_that_equal_the_isovalue_are_inside_on_both_sides)
{
    for (const InsideIs inside : {InsideIs::kAbove, InsideIs::kBelow})
    {
        const Volume volume = random_integer_volume<std::uint8_t>(8, {0.7, 1.0, 2.3});
        const auto oracle = oracle_of(volume, 2.0, inside);
        const auto [nx, ny, nz] = volume.geometry.size;
        const auto& samples = std::get<std::vector<std::uint8_t>>(volume.samples);
        const Vec3& spacing = volume.geometry.spacing;
        for (std::size_t k = 0; k < nz; ++k)
            for (std::size_t j = 0; j < ny; ++j)
                for (std::size_t i = 0; i < nx; ++i)
                {
                    const int sample = samples[i + nx * (j + ny * k)];
                    const Point3 p{spacing.x * static_cast<double>(i), spacing.y * static_cast<double>(j),
                                   spacing.z * static_cast<double>(k)};
                    ASSERT_EQ(is_inside(oracle->region(p)),
                              inside == InsideIs::kAbove ? sample >= 2 : sample <= 2);
                }
    }
}

TEST(TrilinearOracle, a_constant_volume_at_its_own_value_is_a_solid_box)
{
    const auto oracle = oracle_of(volume_of({4, 4, 4}, {1, 1, 1}, std::vector<std::int16_t>(64, 7)), 7.0);
    const auto crossings = crossings_of(*oracle, {{-1, 1.5, 1.5}, {9, 1.5, 1.5}});
    ASSERT_EQ(crossings.size(), 2U);
    EXPECT_TRUE(crossings[0].on_border && crossings[1].on_border);
}

TEST(TrilinearOracle, an_isovalue_outside_the_range_has_no_crossing)
{
    const auto above = oracle_of(ramp({6, 5, 4}), 100.0);
    EXPECT_TRUE(crossings_of(*above, {{-10, 1, 1}, {10, 2, 2}}).empty());
    EXPECT_FALSE(above->may_cross(above->domain().expanded(1.0)));
}

TEST(TrilinearOracle, samples_that_are_not_finite_are_outside)
{
    for (const double bad : {kNaN, kInfinity, -kInfinity})
        for (const InsideIs inside : {InsideIs::kAbove, InsideIs::kBelow})
        {
            const double object = inside == InsideIs::kAbove ? 1.0 : -1.0;
            std::vector<double> samples(std::size_t{7} * 7 * 7, object);
            samples[3 + 7 * (3 + 7 * 3)] = bad;
            const auto oracle = oracle_of(volume_of({7, 7, 7}, {1, 1, 1}, samples), 0.0, inside);
            EXPECT_FALSE(is_inside(oracle->region({3, 3, 3})));
            EXPECT_TRUE(is_inside(oracle->region({4, 3, 3})));
            EXPECT_EQ(crossings_of(*oracle, {{1, 3, 3}, {5, 3, 3}}).size(), 2U);
        }
    const auto nothing =
        oracle_of(volume_of({3, 3, 3}, {1, 1, 1}, std::vector<float>(27, std::nanf(""))), 0.0);
    EXPECT_FALSE(is_inside(nothing->region({1, 1, 1})));
}

TEST(TrilinearOracle, points_that_are_not_finite_lie_in_the_outer_region)
{
    const auto oracle = oracle_of(ramp({6, 5, 4}), -1.0);
    EXPECT_EQ(oracle->region({1, 1, 1}), 1);
    EXPECT_EQ(oracle->region({kNaN, 1, 1}), kOuterRegion);
    EXPECT_EQ(oracle->region({1, kInfinity, 1}), kOuterRegion);
    EXPECT_TRUE(crossings_of(*oracle, {{kNaN, 1, 1}, {1, 1, 1}}).empty());
}

TEST(TrilinearOracle, ends_very_far_away_still_hit)
{
    const auto oracle = oracle_of(ramp({6, 5, 4}), 2.25);
    const auto crossings = crossings_of(*oracle, {{-1e6, 1.3, 1.7}, {1e6, 1.3, 1.7}});
    ASSERT_EQ(crossings.size(), 2U);
    EXPECT_NEAR(crossings[0].point.x, 2.25, 1e-6);
}

//! Smooth and sparse, so that boxes without surface exist; it meets the border.
Volume blobs()
{
    const auto value = [](const Point3& p)
    { return std::sin(0.45 * p.x) + std::cos(0.5 * p.y) * std::sin(0.4 * p.z + 1.0); };
    return sample_volume(value, {30, 26, 28}, {1.0, 0.8, 1.1});
}

TEST(TrilinearOracle, keeps_the_laws_of_oracles)
{
    expect_laws_on_random_segments(*oracle_of(blobs(), 0.9), 10, 100'000);
    expect_laws_on_random_segments(*oracle_of(random_integer_volume<std::int32_t>(11, {1, 2, 3}), 3.0), 11,
                                   20'000);
}

TEST(TrilinearOracle, answers_four_threads_at_once_as_it_answers_one)
{
    expect_same_answers_from_four_threads(*oracle_of(blobs(), 0.9), 20'000);
    expect_same_answers_from_four_threads(*oracle_of(random_float_volume(13, {0.7, 1.0, 2.3}), 0.1), 5000);
}

TEST(TrilinearOracle, a_box_that_may_not_cross_holds_no_crossing_and_one_region)
{
    const auto oracle = oracle_of(blobs(), 0.9);
    Random random(12);
    std::size_t clear = 0;
    for (int i = 0; i < 20'000; ++i)
    {
        const Point3 corner = random_point(random, oracle->domain().expanded(2.0));
        Box3 box{corner, corner};
        box.include(corner + random_point(random, {{-5, -5, -5}, {5, 5, 5}}));
        if (oracle->may_cross(box))
            continue;
        ++clear;
        for (int j = 0; j < 5; ++j)
        {
            const Segment3 segment = random_segment(random, box);
            ASSERT_TRUE(crossings_of(*oracle, segment).empty());
            ASSERT_EQ(oracle->region(segment.source), oracle->region(segment.target));
        }
    }
    EXPECT_GT(clear, 4000U);
}

TEST(TrilinearOracle, refuses_what_has_no_interpolant)
{
    EXPECT_THROW(oracle_of(ramp({1, 5, 4}), 0.5), UsageError);
    EXPECT_THROW(oracle_of(ramp({6, 5, 4}), kNaN), UsageError);
    EXPECT_THROW(oracle_of(volume_of({4, 4, 4}, {1, 1, 1}, std::vector<float>(63)), 0.5), UsageError);
    EXPECT_THROW(make_trilinear_oracle(nullptr, 0.5), UsageError);
}

} // namespace
} // namespace voroprobe
