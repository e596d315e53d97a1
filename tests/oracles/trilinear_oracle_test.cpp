#include "oracles/trilinear_oracle.h"

#include <cmath>
#include <limits>

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
    std::vector<float> samples(13 * 11 * 12);
    for (float& sample : samples)
        sample = static_cast<float>(random.uniform(-1.0, 1.0));
    return volume_of({13, 11, 12}, spacing, samples);
}

//! Whole samples 0 to 4.
template <class Sample>
Volume random_integer_volume(std::uint64_t seed, const Vec3& spacing)
{
    Random random(seed);
    std::vector<Sample> samples(13 * 11 * 12);
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

} // namespace
} // namespace voroprobe
