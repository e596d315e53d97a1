#include "random_volumes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <ostream>

#include "support/random.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

using Index = std::array<std::size_t, 3>;

constexpr std::array<const char*, kVolumeKindCount> kNames{
    "white_noise", "smooth_noise", "integers",       "specks", "checkerboard",
    "thin_sheets", "anisotropic",  "through_border", "blobs",  "shells"};

//! A volume whose samples are given by `value(i, j, k)`, called in order of memory.
template <class Value>
std::shared_ptr<Volume> fill(const Index& size, const Vec3& spacing, Value&& value)
{
    const auto at_grid_point = [&](const Point3& p) {
        return value(std::lround(p.x / spacing.x), std::lround(p.y / spacing.y),
                     std::lround(p.z / spacing.z));
    };
    return std::make_shared<Volume>(sample_volume(at_grid_point, size, spacing));
}

//! A few waves of random direction, about four to nine samples long; between -1 and 1, 0 in the middle.
class Waves
{
public:
    explicit Waves(Random& random)
    {
        for (Wave& wave : waves_)
            wave = {{random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9)},
                    random.uniform(0.0, 6.3)};
    }

    double operator()(long i, long j, long k) const
    {
        double sum = 0.0;
        for (const Wave& wave : waves_)
            sum += std::sin(dot(wave.frequency,
                                {static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)}) +
                            wave.phase);
        return sum / static_cast<double>(waves_.size());
    }

private:
    struct Wave
    {
        Vec3 frequency;
        double phase = 0.0;
    };
    std::array<Wave, 6> waves_;
};

std::shared_ptr<Volume> specks(Random& random, const Index& size)
{
    return fill(size, {1, 1, 1}, [&](long, long, long) { return random.uniform() < 0.06 ? 1.0 : 0.0; });
}

std::shared_ptr<Volume> thin_sheets(Random& random, const Index& size)
{
    const Vec3 normal =
        normalized({random.uniform(0.2, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)});
    const double period = random.uniform(3.0, 5.0);
    return fill(size, {1, 1, 1},
                [&](long i, long j, long k)
                {
                    const double height =
                        dot(normal, {static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
                    return height - period * std::floor(height / period) < 1.0 ? 1.0 : 0.0;
                });
}

std::shared_ptr<Volume> blobs(Random& random, const Index& size)
{
    struct Blob
    {
        Point3 center;
        double radius;
    };
    std::array<Blob, 12> blobs;
    for (Blob& blob : blobs)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            blob.center[axis] = random.uniform(0.0, static_cast<double>(size[axis]));
        blob.radius = random.uniform(0.4, 0.25 * static_cast<double>(size[0]));
    }
    return fill(size, {1, 1, 1},
                [&](long i, long j, long k)
                {
                    const Point3 p{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
                    double height = -1.0;
                    for (const Blob& blob : blobs)
                        height = std::max(height, blob.radius - distance(p, blob.center));
                    return 0.5 + height;
                });
}

std::shared_ptr<Volume> shells(Random& random, const Index& size)
{
    Point3 center;
    for (std::size_t axis = 0; axis < 3; ++axis)
        center[axis] = 0.5 * static_cast<double>(size[axis] - 1) + random.uniform(-0.5, 0.5);
    const double period = random.uniform(1.6, 3.0);
    return fill(size, {1, 1, 1},
                [&](long i, long j, long k)
                {
                    const Point3 p{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
                    return 0.5 + std::sin(2.0 * std::numbers::pi * distance(p, center) / period);
                });
}

std::shared_ptr<Volume> samples_of(VolumeKind kind, Random& random, const Index& size)
{
    const Waves waves(random);
    switch (kind)
    {
    case VolumeKind::kWhiteNoise:
        return fill(size, {1, 1, 1}, [&](long, long, long) { return random.uniform(); });
    case VolumeKind::kSmoothNoise:
        return fill(size, {1, 1.2, 0.9}, [&](long i, long j, long k) { return 0.45 + waves(i, j, k); });
    case VolumeKind::kIntegers:
        return fill(size, {1, 1, 1}, [&](long, long, long) { return static_cast<double>(random.below(4)); });
    case VolumeKind::kSpecks:
        return specks(random, size);
    case VolumeKind::kCheckerboard:
        return fill(size, {1, 1, 1},
                    [&](long i, long j, long k) { return (i + j + k) % 2 == 0 ? 1.0 : 0.0; });
    case VolumeKind::kThinSheets:
        return thin_sheets(random, size);
    case VolumeKind::kAnisotropic:
        return fill({size[0], size[1], std::min<std::size_t>(size[2], 6)}, {1, 1, 8},
                    [&](long i, long j, long k) { return 0.4 + waves(i, j, 2 * k); });
    case VolumeKind::kThroughBorder:
        return fill(size, {1, 1, 1}, [&](long i, long j, long k) { return 0.8 + waves(i, j, k); });
    case VolumeKind::kBlobs:
        return blobs(random, size);
    case VolumeKind::kShells:
        return shells(random, size);
    }
    return nullptr;
}

RandomVolume random_volume(VolumeKind kind, std::uint64_t seed, Random& random, const Index& size)
{
    return {.name = name_of(kind) + ", seed " + std::to_string(seed),
            .volume = samples_of(kind, random, size),
            .isovalue = kind == VolumeKind::kIntegers ? 2.0 : 0.5};
}

} // namespace

std::string name_of(VolumeKind kind)
{
    return kNames[static_cast<std::size_t>(kind)];
}

void PrintTo(VolumeKind kind, std::ostream* out)
{
    *out << name_of(kind);
}

RandomVolume make_random_volume(VolumeKind kind, std::uint64_t seed)
{
    Random random(seed);
    switch (kind)
    {
    case VolumeKind::kWhiteNoise:
        return random_volume(kind, seed, random, {7, 8, 7});
    case VolumeKind::kIntegers:
        return random_volume(kind, seed, random, {7, 7, 8});
    case VolumeKind::kCheckerboard:
        return random_volume(kind, seed, random, {6, 5, 6});
    default:
        const auto side = [&] { return static_cast<std::size_t>(6 + random.below(9)); };
        const Index size{side(), side(), side()};
        return random_volume(kind, seed, random, size);
    }
}

RandomVolume make_random_volume(VolumeKind kind, std::uint64_t seed, std::size_t side)
{
    Random random(seed);
    return random_volume(kind, seed, random, {side, side, side});
}

} // namespace voroprobe
