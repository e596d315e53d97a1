// Speed of the inventory of a scan's surfaces, one thread and all, on a phantom the size of a head CT or on a
// volume given:
//
//     bench_inventory [VOLUME ISOVALUE] [--benchmark_...]
//
// Prints voxels per second, bytes per voxel beside the samples, and surfaces.

#include <cmath>
#include <cstdlib>
#include <memory>

#include <benchmark/benchmark.h>

#include "bench/run_program.h"
#include "io/volume_reader.h"
#include "oracles/region_bricks.h"
#include "support/error.h"
#include "volume/inventory.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

Volume head_sized_phantom()
{
    const auto foam = [](const Point3& p)
    {
        return std::sin(0.11 * p.x) * std::sin(0.13 * p.y) + std::sin(0.17 * p.z + 0.05 * p.x) +
               0.4 * std::sin(0.9 * p.y);
    };
    return sample_volume(foam, {256, 256, 108}, {1.0, 1.0, 1.5});
}

//! Neighbouring samples must be of one region or have a surface between them. \throw UsageError
void check(const Inventory& inventory)
{
    const auto [columns, rows, slices] = inventory.runs().sample_count();
    for (int k = 0; k < slices; ++k)
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i)
            {
                const Region here = inventory.region(i, j, k);
                for (const Region there : {inventory.region(i + 1, j, k), inventory.region(i, j + 1, k),
                                           inventory.region(i, j, k + 1)})
                    if (here != there && inventory.surface_between(here, there) == kNoSurface)
                        throw UsageError("the regions of this volume are no tree");
            }
}

void count_voxels(benchmark::State& state, const Inventory& inventory)
{
    const auto [columns, rows, slices] = inventory.runs().sample_count();
    const double voxels = static_cast<double>(columns) * rows * slices;
    state.counters["voxels/s"] = benchmark::Counter(voxels, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["bytes/voxel"] = static_cast<double>(inventory.memory_bytes()) / voxels;
    state.counters["surfaces"] = static_cast<double>(inventory.surfaces().size());
}

void time_inventory(benchmark::State& state, const HeightField& field, std::size_t threads)
{
    std::unique_ptr<Inventory> inventory;
    for (auto _ : state)
        inventory = std::make_unique<Inventory>(field, threads);
    count_voxels(state, *inventory);
}

//! What an oracle adds for itself.
void time_bricks(benchmark::State& state, const Inventory& inventory)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(RegionBricks(inventory.runs()));
    count_voxels(state, inventory);
}

int run(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (argc != 1 && argc != 3)
        throw UsageError("bench_inventory [VOLUME ISOVALUE] [--benchmark_...]");
    const auto volume =
        std::make_shared<Volume>(argc == 3 ? read_volume(argv[1]).volume : head_sized_phantom());
    const double isovalue = argc == 3 ? std::strtod(argv[2], nullptr) : 0.6;
    const std::unique_ptr<HeightField> field = make_height_field(level_volume(volume, isovalue));
    const Inventory inventory(*field, 1);
    check(inventory);

    const auto add = [&](const char* name, std::size_t threads)
    {
        benchmark::RegisterBenchmark(name, [&field, threads](benchmark::State& state)
                                     { time_inventory(state, *field, threads); })
            ->MeasureProcessCPUTime()
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
    };
    add("inventory/1_thread", 1);
    add("inventory/all_threads", 0);
    benchmark::RegisterBenchmark("region_bricks",
                                 [&inventory](benchmark::State& state) { time_bricks(state, inventory); })
        ->Unit(benchmark::kMillisecond);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

} // namespace
} // namespace voroprobe

int main(int argc, char** argv)
{
    return voroprobe::bench::run_program("bench_inventory", [&] { return voroprobe::run(argc, argv); });
}
