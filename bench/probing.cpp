// What the probing of Voronoi cells costs beside refinement, on one volume: with certified skipping, without
// it, or in a domain many times larger.
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>

#include "bench/run_program.h"
#include "io/volume_reader.h"
#include "mesher/seeded_mesher.h"
#include "oracles/trilinear_oracle.h"
#include "support/stopwatch.h"

namespace voroprobe::bench
{
namespace
{

struct Options
{
    std::string volume;
    double isovalue = 0.0;
    double size = 2.0;
    double angle = 30.0;
    double distance = 0.3;
    double reach = 0.0; //!< 0: the shortest side of a voxel
    double domain_scale = 1.0;
    bool without_skipping = false;
    std::size_t threads = 1;
    std::size_t repeat = 3;
};

//! Another oracle in a domain larger by a factor about the same center.
class WiderOracle final : public SurfaceOracle
{
public:
    WiderOracle(const SurfaceOracle& oracle, double scale) : oracle_(oracle), domain_(oracle.domain())
    {
        const Vec3 half = 0.5 * scale * domain_.extent();
        const Point3 center = domain_.center();
        domain_ = {center - half, center + half};
    }

    [[nodiscard]] Box3 domain() const override { return domain_; }
    [[nodiscard]] Region region(const Point3& p) const override { return oracle_.region(p); }
    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override
    {
        oracle_.find_crossings(segment, crossings);
    }
    [[nodiscard]] bool may_cross(const Box3& box) const override { return oracle_.may_cross(box); }

private:
    const SurfaceOracle& oracle_;
    Box3 domain_;
};

MeshingOptions meshing_options(const Options& options, double voxel_side)
{
    MeshingOptions meshing{.max_facet_radius = options.size,
                           .max_facet_distance = options.distance,
                           .min_facet_angle_deg = options.angle,
                           .floor_radius = 0.25 * voxel_side,
                           .reach_lower_bound = options.reach > 0.0 ? options.reach : voxel_side};
    meshing.certified_skipping = !options.without_skipping;
    meshing.threads = options.threads;
    return meshing;
}

struct Seconds
{
    double processor = 0.0; //!< of all threads: other programs disturb it less than the clock on the wall
    double wall = 0.0;
};

Seconds least(const Seconds& a, const Seconds& b)
{
    return {std::min(a.processor, b.processor), std::min(a.wall, b.wall)};
}

struct Run
{
    MeshingStatistics statistics;
    Seconds seconds;
};

Run run_once(const SurfaceOracle& oracle, const MeshingOptions& meshing)
{
    const std::clock_t begin = std::clock();
    const Stopwatch stopwatch;
    const MeshingStatistics statistics = mesh_surface(oracle, meshing).statistics;
    return {statistics, {static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, stopwatch.seconds()}};
}

//! The best of several runs without probing and with it, in turns.
struct Comparison
{
    Seconds without{1e300, 1e300};
    Seconds with{1e300, 1e300};
    MeshingStatistics statistics; //!< with

    void add_runs(const SurfaceOracle& oracle, MeshingOptions meshing)
    {
        meshing.seeding = Seeding::kIsolated;
        without = least(without, run_once(oracle, meshing).seconds);
        meshing.seeding = Seeding::kProbe;
        const Run run = run_once(oracle, meshing);
        with = least(with, run.seconds);
        statistics = run.statistics;
    }
};

//! Voronoi cells as the report counts them at worst: cubes as wide as the reach, each probed once.
double cubes_of_the_bound(const Box3& domain, double reach)
{
    const Vec3 extent = domain.extent();
    return extent.x * extent.y * extent.z / (reach * reach * reach);
}

void print(const Comparison& runs, double bound)
{
    const MeshingStatistics& with = runs.statistics;
    const auto print_times = [](const char* clock, double without_s, double with_s)
    {
        std::cout << clock << ": refinement " << without_s << " s without probing; probing "
                  << with_s - without_s << " s, ratio " << (with_s - without_s) / without_s << '\n';
    };
    print_times("processor time", runs.without.processor, runs.with.processor);
    print_times("wall clock", runs.without.wall, runs.with.wall);
    std::cout << "  the report's bound, volume / reach^3: " << bound << " probes; spent "
              << with.queries_probing << "\n  insertions " << with.insertions
              << "; Voronoi cells probed at once " << with.cells_probed_at_once << ", probed "
              << with.cells_probed << "; queries " << with.queries_probing << " (refinement "
              << with.queries_refinement << "), hits passed over " << with.probe_hits_passed_over
              << ", inserted " << with.probe_hits << "\n  components by probe(domain) "
              << with.components_by_initialization << ", isolated vertices "
              << with.components_by_isolated_vertex << ", refinement " << with.components_by_refinement
              << ", probing " << with.components_by_probing << '\n';
}

int run(const Options& options)
{
    const auto volume = std::make_shared<const Volume>(read_volume(options.volume).volume);
    const Vec3& spacing = volume->geometry.spacing;
    const auto oracle = make_trilinear_oracle(volume, options.isovalue);
    const WiderOracle wider(*oracle, options.domain_scale);
    const MeshingOptions meshing = meshing_options(options, std::min({spacing.x, spacing.y, spacing.z}));
    const WiderOracle in_its_box(*oracle, 1.0);
    Comparison in_its_domain;
    Comparison in_wider_domain;
    for (std::size_t i = 0; i < options.repeat; ++i)
    {
        in_its_domain.add_runs(in_its_box, meshing);
        if (options.domain_scale != 1.0)
            in_wider_domain.add_runs(wider, meshing);
    }
    std::cout << "reach " << meshing.reach_lower_bound << " mm, threads " << options.threads << '\n';
    print(in_its_domain, cubes_of_the_bound(in_its_box.domain(), meshing.reach_lower_bound));
    if (options.domain_scale != 1.0)
    {
        std::cout << "in a domain " << options.domain_scale << " times longer in each direction:\n";
        print(in_wider_domain, cubes_of_the_bound(wider.domain(), meshing.reach_lower_bound));
        std::cout << "refinement and probing, wider domain / its own: processor time "
                  << in_wider_domain.with.processor / in_its_domain.with.processor << ", wall clock "
                  << in_wider_domain.with.wall / in_its_domain.with.wall << '\n';
    }
    return 0;
}

} // namespace
} // namespace voroprobe::bench

int main(int argc, char** argv)
{
    voroprobe::bench::Options options;
    CLI::App app("Cost of probing Voronoi cells");
    app.add_option("VOLUME", options.volume)->required();
    app.add_option("--isovalue", options.isovalue)->required();
    app.add_option("--size", options.size, "mm")->capture_default_str();
    app.add_option("--angle", options.angle, "degrees")->capture_default_str();
    app.add_option("--distance", options.distance, "mm")->capture_default_str();
    app.add_option("--reach", options.reach, "mm; default: the shortest side of a voxel");
    app.add_option("--domain-scale", options.domain_scale, "make the domain so many times longer and wider")
        ->capture_default_str();
    app.add_flag("--without-skipping", options.without_skipping,
                 "spend the paper's probes on empty space too");
    app.add_option("--threads", options.threads)->capture_default_str();
    app.add_option("--repeat", options.repeat, "runs; the quickest counts")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    return voroprobe::bench::run_program("bench_probing", [&] { return voroprobe::bench::run(options); });
}
