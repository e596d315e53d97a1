#include "cli/seeding_arguments.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "cli/number_text.h"
#include "cli/option_group.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

const NumberRule kDuration{[](double x) { return x > 0.0; }, "a number > 0, seconds"};

constexpr std::string_view kRandomPrefix = "random:";

//! Each may take a hundred rays; more points than this would be a mesh of their own.
constexpr std::size_t kMostRandomPoints = 1'000'000;

//! Under --theorem the floor has to stay out of the way, as a fraction of the size.
constexpr double kTheoremFloorInSizes = 1.0 / 64.0;

void parse_seeding(const std::string& given, SeedingArguments& arguments)
{
    if (given.starts_with(kRandomPrefix))
    {
        arguments.seeding = Seeding::kRandom;
        arguments.random_points = parse_count("--seeding", given.substr(kRandomPrefix.size()), 1);
        if (*arguments.random_points > kMostRandomPoints)
            refuse_value("--seeding", given, "random:N with N up to " + std::to_string(kMostRandomPoints));
    }
    else if (given == "inventory")
        arguments.seeding = Seeding::kInventory;
    else if (given == "probe")
        arguments.seeding = Seeding::kProbe;
    else if (given == "isolated")
        arguments.seeding = Seeding::kIsolated;
    else
        refuse_value("--seeding", given, "inventory, probe, isolated or random:N");
}

//! One point per line, x y z; empty lines and lines that begin with # are passed over.
std::vector<Point3> read_points(const std::filesystem::path& path)
{
    std::ifstream file(path);
    if (!file)
        throw InputError(path.string() + ": cannot be read; expected a text file with x y z on each line");
    std::vector<Point3> points;
    std::string line;
    for (std::size_t number = 1; std::getline(file, line); ++number)
    {
        std::istringstream words(line);
        std::string first;
        if (!(words >> first) || first.front() == '#')
            continue;
        Point3 p;
        std::string rest;
        std::istringstream numbers(line);
        if (!(numbers >> p.x >> p.y >> p.z) || (numbers >> rest) || !is_finite(p))
            throw InputError(path.string() + ", line " + std::to_string(number) + ": \"" + line +
                             "\"; expected three finite numbers");
        points.push_back(p);
    }
    if (points.empty())
        throw InputError(path.string() + ": holds no point; expected x y z on each line");
    return points;
}

} // namespace

void add_seeding_options(CLI::App& command, SeedingArguments& arguments)
{
    OptionGroup group(command, "Finding the components");
    group.text(
        "--seeding", "inventory|probe|isolated|random:N",
        "How components are found: probe is the paper, isolated its\npartial version, random:N what others "
        "do (default: the\ninventory of the volume, or probe where there is none)",
        [&arguments](const std::string& given) { parse_seeding(given, arguments); });
    group.number(
        "--component-radius", "MM", arguments.component_radius, kLength,
        "Every component holds a ball of this radius, at least\n--reach: fewer probes (default --reach)");
    group.text("--components", "K", "Stop looking once so many are meshed (default: look everywhere)",
               [&arguments](const std::string& given)
               { arguments.component_count = parse_count("--components", given, 1); });
    group.text("--seeds", "FILE", "Points on components to begin with: x y z per line, world mm",
               [&arguments](const std::string& given) { arguments.seeds = given; });
    command
        .add_flag(
            "--theorem", arguments.theorem,
            "By the book: size 0.091 --reach, persistent first triangles,\none isolated vertex at a time")
        ->group("Finding the components");
    group.number("--max-seconds", "S", arguments.max_seconds, kDuration,
                 "Stop then, write what there is and exit with 6 (default: no bound)");
}

void check_theorem(const SeedingArguments& arguments, const RequestedCriteria& criteria)
{
    if (arguments.theorem && criteria.size)
        throw UsageError("--size is " + number_text(*criteria.size) +
                         "; allowed with --theorem: none, which makes it " +
                         number_text(kTheoremSizeInReaches) + " times --reach");
}

void apply_seeding(const SeedingArguments& arguments, const GridPlacement& placement, MeshingOptions& options)
{
    options.seeding = arguments.seeding.value_or(options.seeding);
    options.random_points = arguments.random_points.value_or(options.random_points);
    options.component_radius = arguments.component_radius;
    options.component_count = arguments.component_count;
    options.max_seconds = arguments.max_seconds;
    if (arguments.component_radius && *arguments.component_radius < options.reach_lower_bound)
        throw UsageError("--component-radius is " + number_text(*arguments.component_radius) +
                         "; allowed: at least --reach, here " + number_text(options.reach_lower_bound) +
                         " mm");
    if (arguments.theorem)
    {
        options.max_facet_radius = kTheoremSizeInReaches * options.reach_lower_bound;
        options.floor_radius =
            std::min(options.floor_radius, kTheoremFloorInSizes * options.max_facet_radius);
        options.isolated_vertices = IsolatedVertices::kOneAtATime;
        options.persistent_initialization = true;
    }
    if (arguments.seeds)
    {
        const AffineTransform grid_from_world = inverse(placement.world_from_grid);
        for (const Point3& p_world : read_points(*arguments.seeds))
            options.seeds.push_back(grid_from_world * p_world);
    }
}

} // namespace voroprobe
