// Speed of what a mesh is made and looked at with, one thread, on headsq_ct.nrrd of testdata or on a volume
// given:
//
//     bench_pieces [VOLUME ISOVALUE] [--benchmark_...]
//
// Insertion into the restricted Delaunay triangulation, CGAL's insertion of the same points in the same
// order, and the parts of the certificate. bench_oracle_queries and bench_inventory have the others.

#include <cstdlib>
#include <memory>

#include <benchmark/benchmark.h>

#include "bench/run_program.h"
#include "bench/subject.h"
#include "certificate/certificate.h"
#include "certificate/mesh_check.h"
#include "mesher/restricted_delaunay.h"
#include "mesher/seeded_mesher.h"
#include "oracles/trilinear_oracle.h"
#include "support/error.h"

namespace voroprobe::bench
{
namespace
{

//! A scan and our mesh of it, whose vertices are in the order of their insertion.
struct Scan
{
    double voxel;
    std::shared_ptr<const Inventory> inventory;
    std::unique_ptr<const SurfaceOracle> oracle;
    MeshingResult ours;
};

Scan make_scan(Subject subject)
{
    const auto volume = std::make_shared<const Volume>(std::move(subject.volume));
    const double voxel = volume->geometry.min_spacing();
    const LevelledVolume levelled = level_volume(volume, subject.isovalue);
    Scan scan{voxel, std::make_shared<const Inventory>(*make_height_field(levelled)), nullptr, {}};
    scan.oracle = make_trilinear_oracle(levelled, scan.inventory);
    scan.ours = mesh_surface(*scan.oracle, {.max_facet_radius = 2.0 * voxel,
                                            .max_facet_distance = 0.3 * voxel,
                                            .floor_radius = 0.25 * voxel,
                                            .reach_lower_bound = voxel});
    return scan;
}

Certificate certificate_of(const Scan& scan)
{
    return certify(scan.ours.mesh, *scan.oracle, scan.inventory->surfaces(),
                   {.reach = scan.voxel, .floor_radius = 0.25 * scan.voxel, .test_self_intersections = false},
                   scan.ours.surface_of_face);
}

//! What is timed must be right. \throw UsageError
void require_sound(const Scan& scan)
{
    if (const auto found = defects(check_mesh(scan.ours.mesh)))
        throw UsageError("the mesh of this volume has " + *found);
    if (const auto broken = broken_promise(certificate_of(scan)))
        throw UsageError("the mesh of this volume has " + *broken);
}

void count_vertices(benchmark::State& state, const Scan& scan)
{
    state.counters["vertices/s"] = benchmark::Counter(static_cast<double>(scan.ours.mesh.vertices.size()),
                                                      benchmark::Counter::kIsIterationInvariantRate);
}

void time_insertion(benchmark::State& state, const Scan& scan)
{
    MeshingStatistics statistics;
    for (auto _ : state)
    {
        statistics = {};
        RestrictedDelaunay restricted(*scan.oracle, statistics);
        VertexHandle last;
        for (const Point3& p : scan.ours.mesh.vertices)
            if (const VertexHandle vertex = restricted.insert(p, VertexOrigin::kRefinement, last);
                vertex != VertexHandle())
                last = vertex;
    }
    count_vertices(state, scan);
    const auto per_insertion = [&statistics](std::size_t amount)
    { return static_cast<double>(amount) / static_cast<double>(statistics.insertions); };
    state.counters["queries/insertion"] = per_insertion(statistics.queries_refinement);
    state.counters["look-ups/insertion"] = per_insertion(statistics.region_lookups);
}

void time_cgal_insertion(benchmark::State& state, const Scan& scan)
{
    for (auto _ : state)
    {
        CGAL::Delaunay_triangulation_3<Kernel> triangulation;
        CGAL::Delaunay_triangulation_3<Kernel>::Vertex_handle last;
        for (const Point3& p : scan.ours.mesh.vertices)
            last = triangulation.insert(cgal_point(p), last);
    }
    count_vertices(state, scan);
}

void time_check(benchmark::State& state, const Scan& scan)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(check_mesh(scan.ours.mesh));
    count_vertices(state, scan);
}

void time_self_intersections(benchmark::State& state, const Scan& scan)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(self_intersections(scan.ours.mesh));
    count_vertices(state, scan);
}

void time_certificate(benchmark::State& state, const Scan& scan)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(certificate_of(scan));
    count_vertices(state, scan);
}

int run(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (argc != 1 && argc != 3)
        throw UsageError("bench_pieces [VOLUME ISOVALUE] [--benchmark_...]");
    const Scan scan =
        make_scan(argc == 3 ? read_subject(argv[1], std::strtod(argv[2], nullptr)) : read_shipped_subject());
    require_sound(scan);
    const auto add = [&scan](const char* name, void (*time)(benchmark::State&, const Scan&))
    {
        benchmark::RegisterBenchmark(name, [&scan, time](benchmark::State& state) { time(state, scan); })
            ->MeasureProcessCPUTime()
            ->Unit(benchmark::kMillisecond);
    };
    add("insertion/restricted", time_insertion);
    add("insertion/cgal", time_cgal_insertion);
    add("check/mesh", time_check);
    add("check/self_intersections", time_self_intersections);
    add("check/certificate", time_certificate);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

} // namespace
} // namespace voroprobe::bench

int main(int argc, char** argv)
{
    return voroprobe::bench::run_program("bench_pieces", [&] { return voroprobe::bench::run(argc, argv); });
}
