// Delaunay refinement of one volume by us and by CGAL: the same criteria, one thread, results checked before
// they are timed.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/contestants.h"
#include "bench/isolated_run.h"
#include "bench/standings.h"
#include "io/volume_reader.h"
#include "support/error.h"
#include "volume/phantoms.h"

namespace voroprobe::bench
{

namespace
{

enum class Clock
{
    kWall,
    kCpu
};

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
    std::string clock = "wall";
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
                   "radius (its own "
                   "default; the smaller the slower)")
        ->capture_default_str();
    app.add_option("--peers", options.contestants, "contestants, the first is the reference of the ratios")
        ->delimiter(',')
        ->default_str("all");
    app.add_option("--repeat", options.repeat, "timed runs of each, interleaved; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--clock", options.clock, "wall, or cpu: processor time, steadier on a busy machine")
        ->check(CLI::IsMember({"wall", "cpu"}))
        ->capture_default_str();
    app.add_option("--json", options.json, "file for the results");
}

//! A volume, the isovalue that suits it and its name.
struct Subject
{
    Volume volume;
    double isovalue;
    std::string name;
};

//! x^2 + y^2 + z^2 + sin 4x + sin 4y + sin 4z = 0: nested and separate components (Feree & Alliez 2009, Fig.
//! 8), over
//! [-2.5, 2.5]^3 stretched to one scan unit per sample.
Subject make_phantom(std::size_t side)
{
    constexpr double kHalfWidth = 2.5;
    const double scale = 2.0 * kHalfWidth / static_cast<double>(side - 1);
    const auto level = [scale](const Point3& p_grid)
    {
        const Vec3 p = scale * p_grid - Vec3{kHalfWidth, kHalfWidth, kHalfWidth};
        return -(squared_norm(p) + std::sin(4 * p.x) + std::sin(4 * p.y) + std::sin(4 * p.z));
    };
    return {sample_volume(level, {side, side, side}, {1, 1, 1}), 0.0,
            "phantom of " + std::to_string(side) + "^3 samples"};
}

std::filesystem::path data_folder()
{
    if (const char* folder = std::getenv("VOROPROBE_DATA"))
        return folder;
    return std::filesystem::path(VOROPROBE_SOURCE_DIR) / ".." / "shared" / "data";
}

Subject read_subject(const std::filesystem::path& path, double isovalue)
{
    return {read_volume(path).volume, isovalue, path.filename().string()};
}

Subject choose_subject(const Options& options)
{
    if (options.phantom > 0)
        return make_phantom(options.phantom);
    if (!options.volume.empty() && !options.isovalue)
        throw UsageError("--volume needs --isovalue");
    if (!options.volume.empty())
        return read_subject(options.volume, *options.isovalue);

    const auto cranium = data_folder() / "cranium_ct.nrrd";
    if (std::filesystem::exists(cranium))
        return read_subject(cranium, options.isovalue.value_or(226.5));
    const auto shipped = std::filesystem::path(VOROPROBE_SOURCE_DIR) / "testdata" / "headsq_ct.nrrd";
    return read_subject(shipped, options.isovalue.value_or(1150.5));
}

std::string known_names(const std::vector<Entry>& entries)
{
    std::string names;
    for (const Entry& entry : entries)
        names += (names.empty() ? "" : ", ") + entry.name;
    return names;
}

std::vector<Entry> choose_contestants(const std::vector<std::string>& names)
{
    std::vector<Entry> all = all_contestants();
    if (names.empty())
        return all;
    std::vector<Entry> chosen;
    for (const std::string& name : names)
    {
        const auto found =
            std::find_if(all.begin(), all.end(), [&name](const Entry& entry) { return entry.name == name; });
        if (found == all.end())
            throw UsageError("--peers " + name + ": unknown; known are " + known_names(all));
        chosen.push_back(*found);
    }
    return chosen;
}

//! Ours has promised more than CGAL does: a result that breaks the promise is not worth timing.
void require_promises(const Standing& standing)
{
    if (standing.checked.faces == 0)
        throw InputError(standing.name + ": empty mesh");
    if (standing.name == "voroprobe" &&
        (!standing.closed() || !standing.manifold() || standing.checked.misoriented_edges != 0))
        throw Error(ExitStatus::kInternal,
                    standing.name + ": mesh is not closed, manifold and oriented (" +
                        std::to_string(standing.checked.boundary_edges) + " boundary, " +
                        std::to_string(standing.checked.non_manifold_edges) + " non-manifold and " +
                        std::to_string(standing.checked.misoriented_edges) + " misoriented edges)");
}

void add_timed_run(Standing& standing, const RunRecord& run, Clock clock)
{
    // CGAL orders some of its queues by address: its mesh may differ a little from run to run. Ours must not.
    if (standing.name == "voroprobe" &&
        (run.vertices != standing.checked.vertices || run.faces != standing.checked.faces))
        throw Error(ExitStatus::kInternal,
                    standing.name + ": a timed run gave another mesh than the checked one");
    standing.seconds.push_back(clock == Clock::kCpu ? run.cpu_seconds : run.wall_seconds);
    standing.peak_memory_bytes = std::max(standing.peak_memory_bytes, run.peak_memory_bytes);
}

//! One checked run each, then the timed ones in turn: A B C A B C.
std::vector<Standing> compete(const std::vector<Entry>& contestants, const MeshingTask& task,
                              std::size_t repeat, Clock clock)
{
    std::vector<Standing> standings;
    for (const Entry& contestant : contestants)
    {
        standings.push_back({.name = contestant.name,
                             .checked = run_isolated(contestant, task, Checks::kAll),
                             .seconds = {}});
        require_promises(standings.back());
    }
    for (std::size_t round = 0; round < repeat; ++round)
        for (std::size_t i = 0; i < contestants.size(); ++i)
            add_timed_run(standings[i], run_isolated(contestants[i], task, Checks::kNone), clock);
    return standings;
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

void write_json(const std::string& path, const std::string& subject, const std::string& clock,
                const MeshingTask& task, const std::vector<Standing>& standings)
{
    const nlohmann::json report = {{"volume", subject},
                                   {"clock", clock},
                                   {"size", task.volume->geometry.size},
                                   {"isovalue", task.isovalue},
                                   {"max_facet_radius", task.max_facet_radius},
                                   {"min_facet_angle_deg", task.min_facet_angle_deg},
                                   {"max_facet_distance", task.max_facet_distance},
                                   {"floor_radius", task.floor_radius},
                                   {"peer_error_bound", task.peer_error_bound},
                                   {"contestants", to_json(standings)}};
    std::ofstream file(path);
    file << report.dump(2) << '\n';
    if (!file.flush())
        throw OutputError(path + ": cannot be written");
}

void run_benchmark(const Options& options)
{
    const std::vector<Entry> contestants = choose_contestants(options.contestants);
    Subject subject = choose_subject(options);
    const std::string name = subject.name;
    const MeshingTask task = make_task(options, std::move(subject));
    const auto& n = task.volume->geometry.size;
    std::cout << name << " (" << n[0] << " x " << n[1] << " x " << n[2] << "), isovalue " << task.isovalue
              << ", radius " << task.max_facet_radius << " mm, angle " << task.min_facet_angle_deg
              << " deg, distance " << task.max_facet_distance << " mm; median of " << options.repeat << " ("
              << options.clock << " time)\n";

    const std::vector<Standing> standings =
        compete(contestants, task, options.repeat, options.clock == "cpu" ? Clock::kCpu : Clock::kWall);
    print_table(std::cout, standings);
    if (!options.json.empty())
        write_json(options.json, name, options.clock, task, standings);
}

} // namespace

} // namespace voroprobe::bench

int main(int argc, char** argv)
{
    voroprobe::bench::Options options;
    CLI::App app("Delaunay refinement beside CGAL's, one thread, results checked before they are timed");
    voroprobe::bench::add_options(app, options);
    CLI11_PARSE(app, argc, argv);
    try
    {
        voroprobe::bench::run_benchmark(options);
    }
    catch (const voroprobe::Error& error)
    {
        std::cerr << "bench: " << error.what() << '\n';
        return static_cast<int>(error.status());
    }
    catch (const std::exception& error)
    {
        std::cerr << "bench: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
