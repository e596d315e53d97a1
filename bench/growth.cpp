// Whether time per vertex stays what it is from small meshes to large ones, and time per surface from few
// surfaces to many: one scan with falling size, and lattices of spheres.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/growth_run.h"
#include "bench/run_program.h"
#include "bench/subject.h"
#include "support/error.h"
#include "volume/phantoms.h"

namespace voroprobe::bench
{

namespace
{

//! Largest time per piece over smallest that is asked for.
constexpr double kAskedRatio = 1.3;

struct Options
{
    std::string volume; //!< empty: the default one
    std::optional<double> isovalue;
    std::vector<double> sizes{30.0, 10.0, 4.0, 2.0, 1.0, 0.55, 0.28};
    double distance_per_size = 0.15;
    std::vector<std::size_t> surfaces{10, 100, 1000, 10000};
};

void add_options(CLI::App& app, Options& options)
{
    app.add_option("--volume", options.volume,
                   "volume to mesh; default: cranium_ct.nrrd where it is found, else headsq_ct.nrrd");
    app.add_option("--isovalue", options.isovalue, "needed with --volume");
    app.add_option("--sizes", options.sizes, "largest surface Delaunay ball radii, mm; 0: none")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--distance-per-size", options.distance_per_size,
                   "largest center distance, as a share of the size")
        ->capture_default_str();
    app.add_option("--surfaces", options.surfaces, "numbers of spheres; 0: none")
        ->delimiter(',')
        ->capture_default_str();
}

double per(double amount, std::size_t count)
{
    return amount / static_cast<double>(std::max<std::size_t>(count, 1));
}

void print_heading()
{
    std::cout << "part           size mm  surfaces   vertices     cpu s  us/vertex  us/surface  "
                 "queries/ins  look-ups/ins  stale/ins  ins/vertex  bytes/vertex\n";
}

void print_row(const GrowthTask& task, const GrowthRecord& run)
{
    constexpr double kMicro = 1e6;
    const MeshingStatistics& counts = run.statistics;
    const auto per_insertion = [&counts](std::size_t amount)
    { return per(static_cast<double>(amount), counts.insertions); };
    std::cout << std::left << std::setw(12) << (task.part == Part::kWhole ? "whole" : "refinement")
              << std::right << std::fixed << std::setprecision(2) << std::setw(10) << task.size
              << std::setw(10) << run.surfaces << std::setw(11) << run.vertices << std::setw(10)
              << run.cpu_seconds << std::setprecision(1) << std::setw(11)
              << kMicro * per(run.cpu_seconds, run.vertices) << std::setw(12)
              << kMicro * per(run.cpu_seconds, run.surfaces) << std::setprecision(2) << std::setw(13)
              << per_insertion(counts.queries_refinement) << std::setw(14)
              << per_insertion(counts.region_lookups) << std::setw(11)
              << per_insertion(counts.stale_queue_entries) << std::setw(12)
              << per(static_cast<double>(counts.insertions), run.vertices) << std::setprecision(0)
              << std::setw(14) << per(static_cast<double>(run.peak_memory_bytes), run.vertices) << std::endl;
}

//! Largest over smallest.
void print_ratio(const std::string& what, const std::vector<double>& times)
{
    const auto [least, most] = std::minmax_element(times.begin(), times.end());
    const double ratio = *most / *least;
    std::cout << what << ", largest / smallest: " << std::setprecision(2) << ratio << ", asked at most "
              << kAskedRatio << ": " << (ratio <= kAskedRatio ? "holds" : "does NOT hold") << "\n\n";
}

void grow_vertices(const Options& options, Part part)
{
    Subject subject = options.volume.empty() ? read_default_subject(options.isovalue)
                                             : read_subject(options.volume, options.isovalue.value());
    GrowthTask task{.volume = std::make_shared<const Volume>(std::move(subject.volume)),
                    .isovalue = subject.isovalue,
                    .size = 0.0,
                    .distance = 0.0,
                    .part = part};
    std::cout << subject.name << ", isovalue " << subject.isovalue << '\n';
    print_heading();
    std::vector<double> times;
    for (const double size : options.sizes)
    {
        task.size = size;
        task.distance = options.distance_per_size * size;
        const GrowthRecord run = run_growth("size " + std::to_string(size), task);
        print_row(task, run);
        times.push_back(per(run.cpu_seconds, run.vertices));
    }
    print_ratio("time per vertex", times);
}

//! As many balls in a lattice, none like its neighbours to the last bit, in a volume that is no larger than
//! it has to be.
Volume balls(std::size_t count)
{
    constexpr double kPitch = 12.0;
    constexpr double kRadius = 4.0;
    const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(count))));
    const std::size_t layers = (count + side * side - 1) / (side * side);
    const auto level = [=](const Point3& p)
    {
        const auto cell_of = [](double x) { return static_cast<std::size_t>(std::max(x, 0.0) / kPitch); };
        const std::size_t i = cell_of(p.x);
        const std::size_t j = cell_of(p.y);
        const std::size_t k = cell_of(p.z);
        const std::size_t number = (k * side + j) * side + i;
        const double shift = 0.4 * std::sin(static_cast<double>(number));
        const Point3 middle =
            kPitch * Point3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)} +
            Vec3{0.5 * kPitch + shift, 0.5 * kPitch - shift, 0.5 * kPitch + 0.5 * shift};
        const bool is_there = i < side && j < side && number < count;
        return is_there ? kRadius + 0.5 * shift - norm(p - middle) : -kRadius;
    };
    const auto samples = [](std::size_t cells) { return static_cast<std::size_t>(kPitch) * cells + 1; };
    return sample_volume(level, {samples(side), samples(side), samples(layers)}, {1, 1, 1});
}

void grow_surfaces(const std::vector<std::size_t>& counts, Part part)
{
    std::cout << "spheres in a lattice, radius 4 voxels of 1 mm\n";
    print_heading();
    std::vector<double> times;
    for (const std::size_t count : counts)
    {
        const GrowthTask task{.volume = std::make_shared<const Volume>(balls(count)),
                              .isovalue = 0.0,
                              .size = 2.0,
                              .distance = 0.3,
                              .part = part};
        const GrowthRecord run = run_growth(std::to_string(count) + " spheres", task);
        if (part == Part::kWhole && run.surfaces != count)
            throw Error(ExitStatus::kIncomplete, std::to_string(run.surfaces) + " of " +
                                                     std::to_string(count) + " spheres were meshed");
        print_row(task, run);
        times.push_back(per(run.cpu_seconds, run.surfaces));
    }
    print_ratio("time per surface", times);
}

void run(const Options& options)
{
    if (!options.volume.empty() && !options.isovalue)
        throw UsageError("--volume needs --isovalue");
    if (options.sizes != std::vector{0.0})
        for (const Part part : {Part::kRefinement, Part::kWhole})
            grow_vertices(options, part);
    if (options.surfaces != std::vector<std::size_t>{0})
        grow_surfaces(options.surfaces, Part::kWhole);
}

} // namespace

} // namespace voroprobe::bench

int main(int argc, char** argv)
{
    voroprobe::bench::Options options;
    CLI::App app("Time per vertex and per surface as meshes grow, one thread");
    voroprobe::bench::add_options(app, options);
    CLI11_PARSE(app, argc, argv);
    return voroprobe::bench::run_program("bench_growth",
                                         [&]
                                         {
                                             voroprobe::bench::run(options);
                                             return 0;
                                         });
}
