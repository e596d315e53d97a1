// The experiments of Feree & Alliez, RR-8123, 2009, by the numbers of their figures. Exit status 1 where a
// promise is not kept: full probing leaves a component out, the theorem does not hold, or marching cubes is
// nearer to the surface than we can get.
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "bench/paper_figures_output.h"
#include "bench/paper_marching_cubes.h"
#include "bench/paper_theorem.h"
#include <CLI/CLI.hpp>

namespace voroprobe::bench
{
namespace
{

struct Options
{
    std::string figure = "3";
    std::size_t trials = 50;
    std::vector<std::size_t> spheres = {1, 2, 5, 10, 20, 40};
    std::uint64_t seed = 1;
    std::string json;
    std::string svg;
};

Method random_method(std::size_t points)
{
    return {.name = "random, " + std::to_string(points) + " points",
            .seeding = Seeding::kRandom,
            .random_points = points};
}

Method isolated_method()
{
    return {.name = "isolated points", .seeding = Seeding::kIsolated};
}

Method probing_method()
{
    return {.name = "probing", .seeding = Seeding::kProbe, .must_be_complete = true};
}

//! Every volume within a sphere of the random unions holds a ball of radius 1, the smallest sphere.
Method wide_probing_method()
{
    return {.name = "probing, r = 1",
            .seeding = Seeding::kProbe,
            .component_radius = 1.0,
            .must_be_complete = true};
}

//! The corners of a regular tetrahedron.
std::vector<Point3> four_points_on_unit_sphere()
{
    std::vector<Point3> points;
    for (const Vec3& corner : {Vec3{1, 1, 1}, Vec3{1, -1, -1}, Vec3{-1, 1, -1}, Vec3{-1, -1, 1}})
        points.push_back(normalized(corner));
    return points;
}

//! The given trials of scenes that `make_scene` draws, the same scenes for every method.
template <class MakeScene>
void add_rows(Figure& figure, const Options& options, const std::vector<Method>& methods,
              MakeScene make_scene)
{
    std::vector<Row> rows;
    for (const Method& method : methods)
        rows.push_back({.method = method.name, .must_be_complete = method.must_be_complete});
    Random random(options.seed);
    for (std::size_t trial = 0; trial < options.trials; ++trial)
    {
        const Scene scene = make_scene(random);
        const std::uint64_t ray_seed = random.next();
        for (std::size_t i = 0; i < methods.size(); ++i)
        {
            rows[i].components = scene.euler_characteristics.size();
            rows[i].trials.push_back(run_trial(scene, methods[i], ray_seed));
        }
    }
    figure.rows.insert(figure.rows.end(), rows.begin(), rows.end());
}

//! Samples of the domain of a random union on a cubic grid such that every ball of a radius holds one: the
//! side is the radius times 2 / sqrt(3).
std::string grid_samples(double radius)
{
    constexpr double kSide = 200.0;
    const double along_side = std::ceil(kSide * std::sqrt(3.0) / (2.0 * radius)) + 1.0;
    return std::to_string(std::llround(std::pow(along_side, 3)));
}

//! Figures 3 and 7 show the same surfaces, meshed from random points and with isolated vertices.
void run_random_unions(Figure& figure, const Options& options, const std::vector<std::size_t>& counts)
{
    figure.title = "unions of random spheres";
    figure.counted = "spheres";
    figure.note = "a grid with a node in every ball of radius 0.5 has " + grid_samples(0.5) +
                  " samples, of radius 1 " + grid_samples(1.0);
    const std::vector<Method> methods = {random_method(5),  random_method(20), random_method(50),
                                         isolated_method(), probing_method(),  wide_probing_method()};
    for (const std::size_t count : counts)
        add_rows(figure, options, methods, [&](Random& random) { return random_spheres(count, random); });
}

void run_tori(Figure& figure, Options options)
{
    figure.title = "six tori around a sphere";
    options.trials = 1; // nothing random
    const Method seeded{.name = "4 seeds on the sphere",
                        .seeding = Seeding::kRandom,
                        .random_points = 0,
                        .seeds = four_points_on_unit_sphere()};
    add_rows(figure, options, {seeded, isolated_method(), probing_method()},
             [](Random&) { return tori_around_sphere(); });
}

void run_over_seeding(Figure& figure, const Options& options)
{
    figure.title = "over-seeding a sphere";
    add_rows(figure, options, {random_method(5), random_method(50), isolated_method(), probing_method()},
             [](Random&) { return single_sphere(); });
}

//! The report's grid "of size 3r" with 3r from center to center, and with 3r between the spheres: only the
//! latter has the gaps of at least a diameter that its Proposition 1 asks for.
void run_sphere_grid(Figure& figure, Options options)
{
    constexpr std::size_t kSide = 6; // even: the rays begin at the center, which must not be in a sphere
    figure.title = "grids of 216 spheres: centers 3r apart; 3r between the spheres";
    figure.counted = "spheres";
    options.trials = 1; // one set of rays
    const std::vector<Method> methods = {random_method(200), isolated_method(), probing_method()};
    for (const double spacing : {3.0, 5.0})
        add_rows(figure, options, methods, [&](Random&) { return sphere_grid(kSide, spacing); });
}

void run_implicit_surface(Figure& figure, Options options)
{
    options.trials = 1;
    add_rows(figure, options, {random_method(20), isolated_method(), probing_method()},
             [](Random&) { return implicit_surface(); });
}

Figure run_figure(const Options& options)
{
    const int number = std::stoi(options.figure);
    Figure figure{.number = number, .title = "", .counted = "components", .seed = options.seed};
    switch (number)
    {
    case 2:
        run_tori(figure, options);
        break;
    case 3:
    case 7:
        run_random_unions(figure, options, options.spheres);
        break;
    case 4:
        run_over_seeding(figure, options);
        break;
    case 5:
    case 9:
        run_sphere_grid(figure, options);
        break;
    default:
        run_random_unions(figure, options, {10});
        run_implicit_surface(figure, options);
        figure.title = "ten random spheres; the implicit surface (4 components)";
        figure.counted = "components";
        break;
    }
    return figure;
}

Report run_experiment(const Options& options)
{
    if (options.figure == "1")
        return compare_with_marching_cubes();
    if (options.figure == "theorem")
        return check_theorem(options.trials, options.seed);
    return report_of(run_figure(options));
}

void write_text(const std::string& path, const std::string& text)
{
    std::ofstream file(path);
    file << text;
    if (!file.flush())
        throw std::runtime_error(path + ": cannot be written");
}

int run(const Options& options)
{
    const Report report = run_experiment(options);
    std::cout << report.table;
    if (!options.json.empty())
        write_text(options.json, report.json.dump(2) + '\n');
    if (!options.svg.empty())
        write_text(options.svg, report.svg);
    return report.keeps_promises ? 0 : 1;
}

} // namespace
} // namespace voroprobe::bench

int main(int argc, char** argv)
{
    voroprobe::bench::Options options;
    CLI::App app("Figures 1 to 5 and 7 to 9 of Feree & Alliez, RR-8123, 2009, and their theorem");
    app.add_option("--figure", options.figure, "3 and 7 share their surfaces, 5 and 9 theirs")
        ->check(CLI::IsMember({"1", "2", "3", "4", "5", "7", "8", "9", "theorem"}))
        ->capture_default_str();
    app.add_option("--trials", options.trials, "random surfaces, or sets of rays, for each row")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--spheres", options.spheres, "figures 3 and 7: numbers of spheres")
        ->delimiter(',')
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--seed", options.seed, "of the generator")->capture_default_str();
    app.add_option("--json", options.json, "write the rows to this file");
    app.add_option("--svg", options.svg, "plot what counts into this file");
    CLI11_PARSE(app, argc, argv);
    try
    {
        return voroprobe::bench::run(options);
    }
    catch (const std::exception& error)
    {
        std::cerr << "bench_paper_figures: " << error.what() << '\n';
        return 2;
    }
}
