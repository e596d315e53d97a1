#include "bench/standings.h"

#include <algorithm>
#include <iomanip>
#include <ostream>

#include <nlohmann/json.hpp>

namespace voroprobe::bench
{

namespace
{

double share_below(const RunRecord& record)
{
    return record.faces == 0
               ? 0.0
               : static_cast<double>(record.faces_below_angle_bound) / static_cast<double>(record.faces);
}

void print_row(std::ostream& out, const Standing& standing, double reference_rate)
{
    constexpr double kPercent = 100.0;
    const RunRecord& run = standing.checked;
    out << std::left << std::setw(16) << standing.name << std::right << std::fixed //
        << std::setw(10) << run.vertices << std::setw(10) << run.faces             //
        << std::setprecision(2) << std::setw(8) << run.min_angle_deg << std::setw(8) << run.mean_min_angle_deg
        << std::setprecision(3) << std::setw(9) << kPercent * share_below(run)                  //
        << std::setw(7) << run.components << std::setw(8) << (standing.closed() ? "yes" : "NO") //
        << std::setw(10) << (standing.manifold() ? "yes" : "NO")                                //
        << std::setw(10) << standing.median_seconds()                                           //
        << std::setprecision(0) << std::setw(12) << standing.vertices_per_second()              //
        << std::setprecision(2) << std::setw(10) << reference_rate / standing.vertices_per_second()
        << std::setprecision(0) << std::setw(9) << standing.bytes_per_vertex() << '\n';
}

} // namespace

double Standing::median_seconds() const
{
    if (seconds.empty())
        return 0.0;
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t middle = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

double Standing::vertices_per_second() const
{
    const double median = median_seconds();
    return median > 0.0 ? static_cast<double>(checked.vertices) / median : 0.0;
}

double Standing::bytes_per_vertex() const
{
    return checked.vertices == 0
               ? 0.0
               : static_cast<double>(peak_memory_bytes) / static_cast<double>(checked.vertices);
}

void print_table(std::ostream& out, const std::vector<Standing>& standings)
{
    out << "contestant        vertices     faces  min deg    mean  % below  parts  closed  manifold"
           "   seconds  vertices/s     ratio  bytes/v\n";
    const double reference_rate = standings.empty() ? 0.0 : standings.front().vertices_per_second();
    for (const Standing& standing : standings)
        print_row(out, standing, reference_rate);
}

nlohmann::json to_json(const std::vector<Standing>& standings)
{
    nlohmann::json list = nlohmann::json::array();
    for (const Standing& standing : standings)
    {
        const RunRecord& run = standing.checked;
        list.push_back({{"name", standing.name},
                        {"vertices", run.vertices},
                        {"faces", run.faces},
                        {"min_angle_deg", run.min_angle_deg},
                        {"mean_min_angle_deg", run.mean_min_angle_deg},
                        {"faces_below_angle_bound", run.faces_below_angle_bound},
                        {"components", run.components},
                        {"boundary_edges", run.boundary_edges},
                        {"non_manifold_edges", run.non_manifold_edges},
                        {"non_manifold_vertices", run.non_manifold_vertices},
                        {"misoriented_edges", run.misoriented_edges},
                        {"area_mm2", run.area},
                        {"seconds", standing.seconds},
                        {"median_seconds", standing.median_seconds()},
                        {"vertices_per_second", standing.vertices_per_second()},
                        {"peak_memory_bytes", standing.peak_memory_bytes},
                        {"bytes_per_vertex", standing.bytes_per_vertex()}});
    }
    return list;
}

} // namespace voroprobe::bench
