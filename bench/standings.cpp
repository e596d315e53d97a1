#include "bench/standings.h"

#include <algorithm>
#include <iomanip>
#include <ostream>

#include <nlohmann/json.hpp>

namespace voroprobe::bench
{

namespace
{

constexpr double kPercent = 100.0;
constexpr double kMegabyte = 1e6;

double per(double amount, double count)
{
    return count > 0.0 ? amount / count : 0.0;
}

double seconds_of(const RunRecord& run, Clock clock)
{
    return clock == Clock::kCpu ? run.cpu_seconds : run.wall_seconds;
}

void print_quality(std::ostream& out, const Standing& standing)
{
    const RunRecord& run = standing.checked;
    const std::string surfaces =
        std::to_string(run.surfaces_found) + " of " + std::to_string(run.surfaces_there);
    out << std::setprecision(2) << std::setw(8) << run.min_angle_deg << std::setw(7) << run.mean_min_angle_deg
        << std::setprecision(3) << std::setw(8) << kPercent * standing.share_below_30_deg() << std::setw(14)
        << surfaces << std::setw(7) << run.pieces << std::setw(8) << (standing.closed() ? "yes" : "NO")
        << std::setw(10) << (standing.manifold() ? "yes" : "NO") << std::setw(8) << run.distance_max
        << std::setw(8) << run.distance_mean;
}

void print_row(std::ostream& out, const Standing& standing, double reference_rate)
{
    if (standing.failure)
    {
        out << std::left << std::setw(23) << standing.name << "  failed: " << *standing.failure << '\n';
        return;
    }
    const RunRecord& run = standing.checked;
    constexpr int kQualityWidth = 78;
    out << std::left << std::setw(23) << standing.name << std::right << std::fixed << std::setw(10)
        << run.vertices;
    if (standing.kind == Kind::kMesher)
        print_quality(out, standing);
    else
        out << std::setw(kQualityWidth) << "";
    out << std::setprecision(3) << std::setw(9) << standing.median_seconds(Clock::kCpu) << std::setw(9)
        << standing.median_seconds(Clock::kWall) << std::setprecision(0) << std::setw(12)
        << standing.vertices_per_second() << std::setprecision(2) << std::setw(7)
        << per(reference_rate, standing.vertices_per_second()) << std::setprecision(0) << std::setw(7)
        << static_cast<double>(standing.peak_memory_bytes()) / kMegabyte << std::setw(9)
        << standing.bytes_per_vertex() << '\n';
}

nlohmann::json seconds_json(const Standing& standing, Clock clock)
{
    nlohmann::json list = nlohmann::json::array();
    for (const RunRecord& run : standing.timed)
        list.push_back(seconds_of(run, clock));
    return list;
}

nlohmann::json quality_json(const Standing& standing)
{
    const RunRecord& run = standing.checked;
    return {
        {"mean_edge_length_mm", run.mean_edge_length},
        {"min_angle_deg", run.min_angle_deg},
        {"mean_min_angle_deg", run.mean_min_angle_deg},
        {"faces_below_30_deg", run.faces_below_30_deg},
        {"share_below_30_deg", standing.share_below_30_deg()},
        {"surfaces_found", run.surfaces_found},
        {"surfaces_there", run.surfaces_there},
        {"pieces", run.pieces},
        {"boundary_edges", run.boundary_edges},
        {"non_manifold_edges", run.non_manifold_edges},
        {"non_manifold_vertices", run.non_manifold_vertices},
        {"misoriented_edges", run.misoriented_edges},
        {"self_intersections", run.self_intersections},
        {"area_mm2", run.area},
        {"distance_mm",
         {{"max", run.distance_max}, {"mean", run.distance_mean}, {"rms", run.distance_root_mean_square}}}};
}

nlohmann::json to_json(const Standing& standing)
{
    if (standing.failure)
        return {{"name", standing.name}, {"failure", *standing.failure}};
    nlohmann::json json = {{"name", standing.name},
                           {"threads", standing.threads},
                           {"vertices", standing.checked.vertices},
                           {"faces", standing.checked.faces},
                           {"cpu_seconds", seconds_json(standing, Clock::kCpu)},
                           {"wall_seconds", seconds_json(standing, Clock::kWall)},
                           {"median_cpu_seconds", standing.median_seconds(Clock::kCpu)},
                           {"median_wall_seconds", standing.median_seconds(Clock::kWall)},
                           {"vertices_per_second", standing.vertices_per_second()},
                           {"peak_memory_bytes", standing.peak_memory_bytes()},
                           {"bytes_per_vertex", standing.bytes_per_vertex()}};
    if (standing.kind == Kind::kMesher)
        json.update(quality_json(standing));
    return json;
}

} // namespace

double Standing::median_seconds(Clock clock) const
{
    if (timed.empty())
        return 0.0;
    std::vector<double> sorted;
    for (const RunRecord& run : timed)
        sorted.push_back(seconds_of(run, clock));
    std::sort(sorted.begin(), sorted.end());
    const std::size_t middle = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

double Standing::vertices_per_second() const
{
    return per(static_cast<double>(checked.vertices),
               median_seconds(threads == 1 ? Clock::kCpu : Clock::kWall));
}

std::size_t Standing::peak_memory_bytes() const
{
    std::size_t peak = 0;
    for (const RunRecord& run : timed)
        peak = std::max(peak, run.peak_memory_bytes);
    return peak;
}

double Standing::bytes_per_vertex() const
{
    return per(static_cast<double>(peak_memory_bytes()), static_cast<double>(checked.vertices));
}

double Standing::share_below_30_deg() const
{
    return per(static_cast<double>(checked.faces_below_30_deg), static_cast<double>(checked.faces));
}

void print_table(std::ostream& out, const std::vector<Standing>& standings)
{
    out << "contestant               vertices min deg   mean   % <30      surfaces pieces  closed  manifold"
           "  max mm mean mm    cpu s   wall s  vertices/s  ratio     MB  bytes/v\n";
    const double reference_rate = standings.empty() ? 0.0 : standings.front().vertices_per_second();
    for (const Standing& standing : standings)
        print_row(out, standing, reference_rate);
}

nlohmann::json to_json(const std::vector<Standing>& standings)
{
    nlohmann::json list = nlohmann::json::array();
    for (const Standing& standing : standings)
        list.push_back(to_json(standing));
    return list;
}

} // namespace voroprobe::bench
