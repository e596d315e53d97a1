// Time per query of the trilinear oracle, by kind of query, on a phantom the size of a head CT or on a volume
// given:
//
//     bench_oracle_queries [VOLUME ISOVALUE] [--benchmark_filter=...]
//
// Segments are cut like those of a mesher at work: most near the surface, some voxels long.

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "io/volume_reader.h"
#include "oracles/trilinear_oracle.h"
#include "support/error.h"
#include "support/random.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

//! Different queries, so that branches and caches see a mesher's variety. A power of 2: taken in turn by a
//! mask.
constexpr std::size_t kQueries = 1 << 16;
constexpr std::size_t kPerPoint = 32; //!< of them in a row around one point, as at the insertion of a vertex

Volume head_sized_phantom()
{
    const auto foam = [](const Point3& p)
    {
        return std::sin(0.11 * p.x) * std::sin(0.13 * p.y) + std::sin(0.17 * p.z + 0.05 * p.x) +
               0.4 * std::sin(0.9 * p.y);
    };
    return sample_volume(foam, {256, 256, 108}, {1.0, 1.0, 1.5});
}

Point3 random_point(Random& random, const Box3& box)
{
    const double x = random.uniform(box.min.x, box.max.x);
    const double y = random.uniform(box.min.y, box.max.y);
    return {x, y, random.uniform(box.min.z, box.max.z)};
}

//! The volume under test and points on its surface.
struct Subject
{
    std::unique_ptr<SurfaceOracle> oracle;
    double voxel;
    std::vector<Point3> on_surface;
};

Subject make_subject(Volume volume, double isovalue)
{
    Subject subject{nullptr, volume.geometry.min_spacing(), {}};
    subject.oracle = make_trilinear_oracle(std::make_shared<Volume>(std::move(volume)), isovalue);
    Random random(1);
    std::vector<Crossing> crossings;
    for (std::size_t tried = 0; subject.on_surface.size() < kQueries && tried < 100 * kQueries; ++tried)
    {
        const Point3 source = random_point(random, subject.oracle->domain());
        subject.oracle->find_crossings({source, random_point(random, subject.oracle->domain())}, crossings);
        for (const Crossing& crossing : crossings)
            subject.on_surface.push_back(crossing.point);
    }
    if (subject.on_surface.empty())
        throw UsageError("the isovalue has no surface in this volume");
    return subject;
}

//! Segments of `length` voxels whose middle is at most `away` voxels from a point of the surface, in any
//! direction.
std::vector<Segment3> segments_near_surface(const Subject& subject, double length, double away)
{
    Random random(2);
    const Box3 around{{-1, -1, -1}, {1, 1, 1}};
    std::vector<Segment3> segments;
    Point3 on_surface;
    for (std::size_t i = 0; i < kQueries; ++i)
    {
        if (i % kPerPoint == 0)
            on_surface = subject.on_surface[random.below(subject.on_surface.size())];
        const Point3 middle = on_surface + away * subject.voxel * random_point(random, around);
        const Vec3 half = 0.5 * length * subject.voxel * normalized(random_point(random, around));
        segments.push_back({middle - half, middle + half});
    }
    return segments;
}

enum class Meets
{
    kSurface,
    kNothing
};

//! Those that meet the surface, or those that do not, as often as it takes to have as many as there were.
std::vector<Segment3> only(Meets meets, const Subject& subject, const std::vector<Segment3>& segments)
{
    std::vector<Segment3> chosen;
    std::vector<Crossing> crossings;
    for (const Segment3& segment : segments)
    {
        subject.oracle->find_crossings(segment, crossings);
        if (crossings.empty() == (meets == Meets::kNothing))
            chosen.push_back(segment);
    }
    if (chosen.empty())
        throw UsageError("no segments of this kind in this volume");
    const std::size_t count = chosen.size();
    for (std::size_t i = 0; chosen.size() < kQueries; ++i)
        chosen.push_back(chosen[i % count]);
    return chosen;
}

void time_segments(benchmark::State& state, const SurfaceOracle& oracle,
                   const std::vector<Segment3>& segments)
{
    std::vector<Crossing> crossings;
    std::size_t found = 0;
    std::size_t i = 0;
    for (auto _ : state)
    {
        oracle.find_crossings(segments[i++ & (kQueries - 1)], crossings);
        found += crossings.size();
    }
    state.counters["crossings"] =
        benchmark::Counter(static_cast<double>(found), benchmark::Counter::kAvgIterations);
}

void time_regions(benchmark::State& state, const SurfaceOracle& oracle,
                  const std::vector<Segment3>& at_sources)
{
    std::size_t i = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(oracle.region(at_sources[i++ & (kQueries - 1)].source));
}

void register_all(const Subject& subject)
{
    const SurfaceOracle& oracle = *subject.oracle;
    const auto add = [&](const char* name, const std::vector<Segment3>& segments)
    {
        benchmark::RegisterBenchmark(name, [&oracle, segments](benchmark::State& state)
                                     { time_segments(state, oracle, segments); });
    };
    const auto near = segments_near_surface(subject, 4.0, 2.0);
    add("segment/hit", only(Meets::kSurface, subject, near));
    add("segment/miss", only(Meets::kNothing, subject, near));
    add("segment/short_dual_edge", segments_near_surface(subject, 0.25, 0.1));
    add("segment/1_voxel_at_surface", segments_near_surface(subject, 1.0, 0.5));
    add("segment/4_voxels_at_surface", near);
    add("segment/4_voxels_within_10", segments_near_surface(subject, 4.0, 10.0));
    add("segment/20_voxels_at_surface", segments_near_surface(subject, 20.0, 10.0));
    add("segment/200_voxels_at_surface", segments_near_surface(subject, 200.0, 50.0));
    const auto within_10 = segments_near_surface(subject, 4.0, 10.0);
    benchmark::RegisterBenchmark("region/at_surface", [&oracle, near](benchmark::State& state)
                                 { time_regions(state, oracle, near); });
    benchmark::RegisterBenchmark("region/within_10_voxels", [&oracle, within_10](benchmark::State& state)
                                 { time_regions(state, oracle, within_10); });
}

int run(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (argc != 1 && argc != 3)
        throw UsageError("bench_oracle_queries [VOLUME ISOVALUE] [--benchmark_...]");
    const Subject subject = argc == 3
                                ? make_subject(read_volume(argv[1]).volume, std::strtod(argv[2], nullptr))
                                : make_subject(head_sized_phantom(), 0.6);
    register_all(subject);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

} // namespace
} // namespace voroprobe

int main(int argc, char** argv)
{
    try
    {
        return voroprobe::run(argc, argv);
    }
    catch (const std::exception& error)
    {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
