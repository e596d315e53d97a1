#include "certificate/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "certificate/mesh_samples.h"
#include "certificate/space_order.h"
#include "mesh/measures.h"
#include "support/random.h"

namespace voroprobe
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

//! Lines shot in the first attempt, per point wanted: a line through a scan meets a few crossings.
constexpr double kFirstLinesPerPoint = 0.125;

//! Where lines met too few crossings, so many times as many are shot next.
constexpr double kMoreLines = 4.0;

//! No more lines than so many per point wanted: the surface is too small in its box.
constexpr double kMostLinesPerPoint = 8.0;

//! Searches from a mesh begin with this share of a typical edge: meshes are nearer to their surface than
//! that.
constexpr double kFirstReach = 0.25;

//! Random numbers of one line, whichever thread draws them. The factor is that of SplitMix64.
Random random_of_line(std::uint64_t seed, std::uint64_t attempt, std::uint64_t line)
{
    return Random(seed + 0x9E3779B97F4A7C15ULL * (line + (attempt << 40U)) + 1);
}

//! Lines along one axis, one through a random point of every cell of a lattice across the box.
class LineLattice
{
public:
    LineLattice(const Box3& box, std::size_t axis, double lines) : box_(box), axis_(axis)
    {
        const Vec3 extent = box.extent();
        const double width = extent[u()];
        const double height = extent[v()];
        const double cell = std::sqrt(width * height / lines);
        columns_ = cell > 0.0 ? static_cast<std::size_t>(std::ceil(width / cell)) : 1;
        rows_ = cell > 0.0 ? static_cast<std::size_t>(std::ceil(height / cell)) : 1;
    }

    [[nodiscard]] std::size_t size() const { return columns_ * rows_; }

    //! Line number `line`, from end to end of the box and a little farther.
    [[nodiscard]] Segment3 line(std::size_t line, Random random) const
    {
        const double margin = 0.01 * box_.diagonal();
        Segment3 segment{box_.min, box_.min};
        segment.source[u()] += place(line % columns_, columns_, box_.extent()[u()], random);
        segment.source[v()] += place(line / columns_, rows_, box_.extent()[v()], random);
        segment.target = segment.source;
        segment.source[axis_] = box_.min[axis_] - margin;
        segment.target[axis_] = box_.max[axis_] + margin;
        return segment;
    }

private:
    [[nodiscard]] std::size_t u() const { return (axis_ + 1) % 3; }
    [[nodiscard]] std::size_t v() const { return (axis_ + 2) % 3; }

    static double place(std::size_t cell, std::size_t cells, double extent, Random& random)
    {
        return extent * (static_cast<double>(cell) + random.uniform()) / static_cast<double>(cells);
    }

    Box3 box_;
    std::size_t axis_;
    std::size_t columns_;
    std::size_t rows_;
};

void append_crossings_of_lines(const SurfaceOracle& oracle, const LineLattice& lattice, std::uint64_t seed,
                               std::uint64_t attempt, BorderCaps caps, std::vector<Point3>& points)
{
    std::vector<std::vector<Point3>> of_line(lattice.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, lattice.size()),
                      [&](const tbb::blocked_range<std::size_t>& range)
                      {
                          std::vector<Crossing> crossings;
                          for (std::size_t i = range.begin(); i < range.end(); ++i)
                          {
                              oracle.find_crossings(lattice.line(i, random_of_line(seed, attempt, i)),
                                                    crossings);
                              for (const Crossing& crossing : crossings)
                                  if (caps == BorderCaps::kCounted || !crossing.on_border)
                                      of_line[i].push_back(crossing.point);
                          }
                      });
    for (const std::vector<Point3>& here : of_line)
        points.insert(points.end(), here.begin(), here.end());
}

std::vector<Point3> crossings_of_lines(const SurfaceOracle& oracle, const SamplingOptions& options,
                                       double lines, std::uint64_t attempt)
{
    const Box3 box = options.box.value_or(oracle.domain());
    std::vector<Point3> points;
    for (std::size_t axis = 0; axis < 3; ++axis)
        append_crossings_of_lines(oracle, LineLattice(box, axis, lines / 3.0), options.seed,
                                  3 * attempt + axis, options.caps, points);
    return points;
}

//! `count` of them at even steps.
void thin_out(std::vector<Point3>& points, std::size_t count)
{
    if (points.size() <= count)
        return;
    for (std::size_t i = 0; i < count; ++i)
        points[i] = points[i * points.size() / count];
    points.resize(count);
}

//! Calls `distance_at(i, search)` for every sample, on all cores; what it keeps between samples is one per
//! thread.
template <typename MakeSearch, typename DistanceAt>
std::vector<double> distances_of(std::size_t count, MakeSearch make_search, DistanceAt distance_at)
{
    std::vector<double> distances(count);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                      [&](const tbb::blocked_range<std::size_t>& range)
                      {
                          auto search = make_search();
                          for (std::size_t i = range.begin(); i < range.end(); ++i)
                              distances[i] = distance_at(i, search);
                      });
    return distances;
}

template <typename PointAt>
void take_largest(const std::vector<double>& distances, PointAt point_at, DirectedDistance& result)
{
    result.samples += distances.size();
    for (std::size_t i = 0; i < distances.size(); ++i)
        if (distances[i] > result.max)
        {
            result.max = distances[i];
            result.max_at = point_at(i);
        }
}

void take_averages(std::vector<double> distances, DirectedDistance& result)
{
    if (distances.empty())
        return;
    double sum = 0.0;
    double sum_of_squares = 0.0;
    for (const double d : distances)
    {
        sum += d;
        sum_of_squares += d * d;
    }
    const auto count = static_cast<double>(distances.size());
    result.mean = sum / count;
    result.root_mean_square = std::sqrt(sum_of_squares / count);
    std::sort(distances.begin(), distances.end());
    result.percentile_95 = distances[static_cast<std::size_t>(0.95 * (count - 1.0))];
    result.spread = std::move(distances);
}

double distance_to_points(const Point3& p, const std::vector<Point3>& points)
{
    double squared = kInfinity;
    for (const Point3& q : points)
        squared = std::min(squared, squared_distance(p, q));
    return std::sqrt(squared);
}

//! Points that no segment finds the surface from have the nearest known point of it.
std::vector<double> distances_to_surface(const std::vector<MeshSample>& samples, const SurfaceOracle& oracle,
                                         BorderCaps caps, double first_reach,
                                         const std::vector<Point3>& known)
{
    const double last_reach = oracle.domain().diagonal();
    return distances_of(
        samples.size(), [&] { return NearestCrossing(oracle, caps); },
        [&](std::size_t i, NearestCrossing& search)
        {
            const auto found = search.near(samples[i].point, samples[i].normal, first_reach, last_reach);
            return found ? found->distance : distance_to_points(samples[i].point, known);
        });
}

DirectedDistance distance_from_mesh(const TriangleMesh& mesh, double total_area, const SurfaceOracle& oracle,
                                    const SamplingOptions& options, const std::vector<Point3>& surface_points)
{
    const double first_reach = kFirstReach * typical_edge_length(mesh, total_area);
    Random random(options.seed);
    const auto landmarks = mesh_landmarks(mesh, options.mesh_samples / 2);
    const auto spread = area_samples(mesh, total_area, options.mesh_samples - landmarks.size(), random);
    DirectedDistance result;
    auto distances = distances_to_surface(landmarks, oracle, options.caps, first_reach, surface_points);
    take_largest(
        distances, [&](std::size_t i) { return landmarks[i].point; }, result);
    distances = distances_to_surface(spread, oracle, options.caps, first_reach, surface_points);
    take_largest(
        distances, [&](std::size_t i) { return spread[i].point; }, result);
    take_averages(std::move(distances), result);
    return result;
}

DirectedDistance distance_from_surface(const std::vector<Point3>& lines_points,
                                       const std::vector<Point3>& given, const FaceTree& tree)
{
    const auto distances_to_mesh = [&](const std::vector<Point3>& points)
    {
        // Neighbours look into the same boxes.
        const std::vector<std::uint32_t> order = order_in_space(points);
        std::vector<double> distances(points.size());
        tbb::parallel_for(std::size_t{0}, order.size(),
                          [&](std::size_t i) { distances[order[i]] = tree.distance(points[order[i]]); });
        return distances;
    };
    DirectedDistance result;
    take_largest(
        distances_to_mesh(given), [&](std::size_t i) { return given[i]; }, result);
    auto distances = distances_to_mesh(lines_points);
    take_largest(
        distances, [&](std::size_t i) { return lines_points[i]; }, result);
    take_averages(std::move(distances), result);
    return result;
}

DirectedDistance infinitely_far(const std::vector<Point3>& points)
{
    return {.samples = points.size(),
            .max = kInfinity,
            .max_at = points.empty() ? Point3{} : points.front(),
            .mean = kInfinity,
            .root_mean_square = kInfinity,
            .percentile_95 = kInfinity,
            .spread = {}};
}

} // namespace

double SurfaceDistance::max() const
{
    return std::max(from_mesh.max, from_surface.max);
}

double SurfaceDistance::mean() const
{
    return 0.5 * (from_mesh.mean + from_surface.mean);
}

std::vector<Point3> sample_surface(const SurfaceOracle& oracle, const SamplingOptions& options)
{
    const auto wanted = static_cast<double>(options.surface_samples);
    double lines = std::max(3.0, kFirstLinesPerPoint * wanted);
    std::vector<Point3> points = crossings_of_lines(oracle, options, lines, 0);
    for (std::uint64_t attempt = 1; 2 * points.size() < options.surface_samples; ++attempt)
    {
        lines *= kMoreLines;
        if (lines > kMostLinesPerPoint * wanted)
            break;
        points = crossings_of_lines(oracle, options, lines, attempt);
    }
    thin_out(points, options.surface_samples);
    return points;
}

SurfaceDistance surface_distance(const TriangleMesh& mesh, const SurfaceOracle& oracle,
                                 const SamplingOptions& options, std::span<const Point3> surface_points)
{
    return surface_distance(FaceTree(mesh), oracle, options, surface_points);
}

SurfaceDistance surface_distance(const FaceTree& tree, const SurfaceOracle& oracle,
                                 const SamplingOptions& options, std::span<const Point3> surface_points)
{
    const std::vector<Point3> points = sample_surface(oracle, options);
    const std::vector<Point3> given(surface_points.begin(), surface_points.end());
    const double total_area = area(tree.mesh());
    if (!(total_area > 0.0))
        return {.from_mesh = {},
                .from_surface =
                    points.empty() && given.empty() ? DirectedDistance{} : infinitely_far(points)};
    std::vector<Point3> all = points;
    all.insert(all.end(), given.begin(), given.end());
    return {.from_mesh = distance_from_mesh(tree.mesh(), total_area, oracle, options, all),
            .from_surface = distance_from_surface(points, given, tree)};
}

} // namespace voroprobe
