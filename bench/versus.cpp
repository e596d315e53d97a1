// One volume meshed by us and by others: the same criteria where they take any, results checked before they
// are timed, and what was measured held against what is asked of us.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/contest.h"
#include "bench/contestants.h"
#include "bench/run_program.h"
#include "bench/standings.h"
#include "bench/subject.h"
#include "bench/targets.h"
#include "oracles/trilinear_oracle.h"
#include "support/error.h"
#include "support/thread_limit.h"

namespace voroprobe::bench
{

namespace
{

struct Options
{
    std::string volume;      //!< empty: the default one
    std::size_t phantom = 0; //!< samples along each side of a phantom; 0: none
    std::optional<double> isovalue;
    double size = 2.0;
    double angle = 30.0;
    double distance = 0.3;
    std::optional<double> floor;
    double peer_error_bound = 1e-3;
    std::vector<std::string> contestants; //!< empty: all
    std::size_t repeat = 5;
    std::string json;
};

void add_options(CLI::App& app, Options& options)
{
    app.add_option("--volume", options.volume,
                   "volume to mesh; default: cranium_ct.nrrd where it is found, else headsq_ct.nrrd");
    app.add_option("--phantom", options.phantom, "mesh a synthetic volume of N^3 samples instead")
        ->check(CLI::Range(8, 512));
    app.add_option("--isovalue", options.isovalue, "needed with --volume");
    app.add_option("--size", options.size, "largest surface Delaunay ball radius, mm")->capture_default_str();
    app.add_option("--angle", options.angle, "smallest facet angle, degrees")->capture_default_str();
    app.add_option("--distance", options.distance, "largest center distance, mm")->capture_default_str();
    app.add_option("--floor", options.floor,
                   "floor radius of ours, mm; default: a quarter of the shortest voxel side");
    app.add_option("--peer-error-bound", options.peer_error_bound,
                   "CGAL's relative_error_bound: error of its intersections as a share of the domain's "
                   "radius (its own default; the smaller the slower)")
        ->capture_default_str();
    app.add_option("--peers", options.contestants, "contestants, the first is the reference of the ratios")
        ->delimiter(',')
        ->default_str("all");
    app.add_option("--repeat", options.repeat, "timed runs of each, interleaved; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--json", options.json, "file for the results");
}

Subject choose_subject(const Options& options)
{
    if (options.phantom > 0)
        return make_phantom(options.phantom);
    if (options.volume.empty())
        return read_default_subject(options.isovalue);
    if (!options.isovalue)
        throw UsageError("--volume needs --isovalue");
    return read_subject(options.volume, *options.isovalue);
}

const Entry& find(const std::vector<Entry>& entries, const std::string& name)
{
    std::string known;
    for (const Entry& entry : entries)
    {
        if (entry.name == name)
            return entry;
        known += (known.empty() ? "" : ", ") + entry.name;
    }
    throw UsageError("--peers " + name + ": unknown; known are " + known);
}

std::vector<Entry> choose_contestants(const std::vector<Entry>& all, const std::vector<std::string>& names)
{
    std::vector<Entry> chosen;
    for (const std::string& name : names)
        chosen.push_back(find(all, name));
    return names.empty() ? all : chosen;
}

MeshingTask make_task(const Options& options, Subject subject)
{
    const auto volume = std::make_shared<const Volume>(std::move(subject.volume));
    return {.volume = volume,
            .isovalue = options.isovalue.value_or(subject.isovalue),
            .min_facet_angle_deg = options.angle,
            .max_facet_radius = options.size,
            .max_facet_distance = options.distance,
            .floor_radius = options.floor.value_or(0.25 * volume->geometry.min_spacing()),
            .reach = volume->geometry.min_spacing(),
            .peer_error_bound = options.peer_error_bound};
}

//! On one thread: processes are forked from this one.
ReferenceSurface make_reference(const MeshingTask& task)
{
    const ThreadLimit one(1);
    const LevelledVolume levelled = level_volume(task.volume, task.isovalue, task.inside);
    const auto inventory = std::make_shared<const Inventory>(*make_height_field(levelled), 1);
    const GridGeometry& geometry = task.volume->geometry;
    const Vec3& spacing = geometry.spacing;
    return {.oracle = make_trilinear_oracle(levelled, inventory),
            .inventory = inventory,
            .world_from_grid = geometry.world_from_grid,
            .voxel = std::cbrt(spacing.x * spacing.y * spacing.z)};
}

void print_heading(const std::string& name, const MeshingTask& task, std::size_t repeat)
{
    const auto& n = task.volume->geometry.size;
    std::cout << name << " (" << n[0] << " x " << n[1] << " x " << n[2] << "), isovalue " << task.isovalue
              << ", radius " << task.max_facet_radius << " mm, angle " << task.min_facet_angle_deg
              << " deg, distance " << task.max_facet_distance << " mm; medians of " << repeat
              << ", vertices/s by processor time, by the clock on the wall on two threads\n";
}

void write_json(const std::string& path, const std::string& subject, const MeshingTask& task,
                const std::vector<Standing>& standings, const std::vector<Target>& targets)
{
    const nlohmann::json report = {{"volume", subject},
                                   {"size", task.volume->geometry.size},
                                   {"isovalue", task.isovalue},
                                   {"max_facet_radius", task.max_facet_radius},
                                   {"min_facet_angle_deg", task.min_facet_angle_deg},
                                   {"max_facet_distance", task.max_facet_distance},
                                   {"floor_radius", task.floor_radius},
                                   {"peer_error_bound", task.peer_error_bound},
                                   {"contestants", to_json(standings)},
                                   {"targets", to_json(targets)}};
    std::ofstream file(path);
    file << report.dump(2) << '\n';
    if (!file.flush())
        throw OutputError(path + ": cannot be written");
}

void run_benchmark(const Options& options)
{
    Subject subject = choose_subject(options);
    const std::string name = subject.name;
    const std::optional<std::filesystem::path> file = subject.file;
    const MeshingTask task = make_task(options, std::move(subject));
    const ReferenceSurface reference = make_reference(task);
    const std::vector<Entry> all = all_contestants(reference, file);
    const std::vector<Entry> contestants = choose_contestants(all, options.contestants);
    print_heading(name, task, options.repeat);

    const std::vector<Standing> standings =
        compete(find(all, kOurs), contestants, task, reference, options.repeat);
    const std::vector<Target> targets = evaluate_targets(standings, task.volume->geometry.sample_count());
    print_table(std::cout, standings);
    std::cout << '\n';
    print_targets(std::cout, targets);
    if (!options.json.empty())
        write_json(options.json, name, task, standings, targets);
}

} // namespace

} // namespace voroprobe::bench

int main(int argc, char** argv)
{
    voroprobe::bench::Options options;
    CLI::App app("One volume meshed by us and by others, results checked before they are timed");
    voroprobe::bench::add_options(app, options);
    CLI11_PARSE(app, argc, argv);
    return voroprobe::bench::run_program("bench_versus",
                                         [&]
                                         {
                                             voroprobe::bench::run_benchmark(options);
                                             return 0;
                                         });
}
