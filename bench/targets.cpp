#include "bench/targets.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <iomanip>
#include <map>
#include <ostream>

#include <nlohmann/json.hpp>

namespace voroprobe::bench
{

namespace
{

using Bound = Target::Bound;

//! Memory that may be taken for each voxel, beside the samples.
constexpr double kBytesPerVoxel = 5.0;

double cpu(const Standing& standing)
{
    return standing.median_seconds(Clock::kCpu);
}

double wall(const Standing& standing)
{
    return standing.median_seconds(Clock::kWall);
}

//! Adds a target where all that it speaks of was run and did not fail.
class Evaluation
{
public:
    explicit Evaluation(const std::vector<Standing>& standings)
    {
        for (const Standing& standing : standings)
            if (!standing.failure)
                by_name_.emplace(standing.name, &standing);
    }

    template <typename Measure, typename... Names>
    void add(std::string what, Bound bound, double asked, Measure measure, Names... names)
    {
        if ((by_name_.contains(names) && ...))
            targets_.push_back({std::move(what), measure(*by_name_.at(names)...), bound, asked});
    }

    std::vector<Target> take() { return std::move(targets_); }

private:
    std::map<std::string, const Standing*> by_name_;
    std::vector<Target> targets_;
};

double rate_ratio(const Standing& ours, const Standing& theirs)
{
    return ours.vertices_per_second() / theirs.vertices_per_second();
}

double cpu_ratio(const Standing& ours, const Standing& theirs)
{
    return cpu(ours) / cpu(theirs);
}

double speed_up(const Standing& one, const Standing& two)
{
    return wall(one) / wall(two);
}

void add_quality(Evaluation& evaluation)
{
    evaluation.add(
        "surfaces of the scan that are in our mesh, share", Bound::kAtLeast, 1.0,
        [](const Standing& ours)
        {
            return static_cast<double>(ours.checked.surfaces_found) /
                   static_cast<double>(std::max<std::size_t>(ours.checked.surfaces_there, 1));
        },
        kOurs);
}

void add_one_thread(Evaluation& evaluation)
{
    evaluation.add("refinement, vertices/s: Mesh_3 after its image scan", Bound::kAtLeast, 4.0, rate_ratio,
                   kRefinement, kMesh3Scan);
    evaluation.add("refinement, vertices/s: surface mesher", Bound::kAtLeast, 7.0, rate_ratio, kRefinement,
                   kSurfaceMesher);
    evaluation.add("all of ours, time: Mesh_3", Bound::kAtMost, 1.0, cpu_ratio, kOurs, kMesh3);
    evaluation.add("all of ours, time: Mesh_3 after its image scan", Bound::kAtMost, 1.0, cpu_ratio, kOurs,
                   kMesh3Scan);
    evaluation.add("refinement, time: bulk insertion of our vertices", Bound::kAtMost, 2.0, cpu_ratio,
                   kRefinement, kBulkInsertion);
    evaluation.add("all of ours, time: bulk insertion of our vertices", Bound::kAtMost, 2.0, cpu_ratio, kOurs,
                   kBulkInsertion);
    evaluation.add(
        "inventory and certificate, time: refinement", Bound::kAtMost, 0.2,
        [](const Standing& inventory, const Standing& certificate, const Standing& refinement)
        { return (cpu(inventory) + cpu(certificate)) / cpu(refinement); },
        kInventory, kCertificate, kRefinement);
}

void add_two_threads(Evaluation& evaluation)
{
    evaluation.add("refinement, two threads: one (wall)", Bound::kAtLeast, 1.6, speed_up, kRefinement,
                   kRefinementOnTwo);
    evaluation.add("all of ours, two threads: one (wall)", Bound::kAtLeast, 1.6, speed_up, kOurs, kOursOnTwo);
    evaluation.add("refinement on two, vertices/s: parallel Mesh_3 on two (wall)", Bound::kAtLeast, 2.0,
                   rate_ratio, kRefinementOnTwo, kMesh3OnTwo);
    evaluation.add("refinement on two, vertices/s: the same after its image scan (wall)", Bound::kAtLeast,
                   2.0, rate_ratio, kRefinementOnTwo, kMesh3ScanOnTwo);
}

void add_whole_commands(Evaluation& evaluation)
{
    evaluation.add("file to STL, time: FlyingEdges and decimation", Bound::kAtMost, 0.7, cpu_ratio, kCommand,
                   kDecimatedFile);
    evaluation.add("file to STL, time: FlyingEdges and remeshing", Bound::kAtMost, 0.3, cpu_ratio, kCommand,
                   kRemeshedFile);
}

void add_memory(Evaluation& evaluation, std::size_t voxels)
{
    constexpr double kBytesPerVertex = 900.0;
    const auto per_vertex = [](const Standing& ours) { return ours.bytes_per_vertex(); };
    const auto beyond_voxels = [voxels](const Standing& ours)
    {
        const double bytes =
            static_cast<double>(ours.peak_memory_bytes()) - kBytesPerVoxel * static_cast<double>(voxels);
        return std::max(bytes, 0.0) / static_cast<double>(ours.checked.vertices);
    };
    evaluation.add("refinement, bytes per vertex", Bound::kAtMost, kBytesPerVertex, per_vertex, kRefinement);
    evaluation.add("all of ours, bytes per vertex", Bound::kAtMost, kBytesPerVertex, per_vertex, kOurs);
    evaluation.add("all of ours, bytes per vertex beyond 5 bytes per voxel", Bound::kAtMost, kBytesPerVertex,
                   beyond_voxels, kOurs);
}

} // namespace

std::vector<Target> evaluate_targets(const std::vector<Standing>& standings, std::size_t voxels)
{
    Evaluation evaluation(standings);
    add_quality(evaluation);
    add_one_thread(evaluation);
    add_two_threads(evaluation);
    add_whole_commands(evaluation);
    add_memory(evaluation, voxels);
    return evaluation.take();
}

void print_targets(std::ostream& out, const std::vector<Target>& targets)
{
    out << std::left << std::setw(75) << "target" << std::right << std::setw(10) << "measured"
        << std::setw(15) << "asked"
        << "  holds\n";
    for (const Target& target : targets)
        out << std::left << std::setw(75) << target.what << std::right << std::fixed << std::setprecision(2)
            << std::setw(10) << target.measured
            << (target.bound == Bound::kAtLeast ? "  at least " : "   at most ") << std::setprecision(1)
            << std::setw(6) << target.asked << (target.holds() ? "  yes" : "  NO") << '\n';
}

nlohmann::json to_json(const std::vector<Target>& targets)
{
    nlohmann::json list = nlohmann::json::array();
    for (const Target& target : targets)
        list.push_back({{"target", target.what},
                        {"measured", target.measured},
                        {target.bound == Bound::kAtLeast ? "at_least" : "at_most", target.asked},
                        {"holds", target.holds()}});
    return list;
}

} // namespace voroprobe::bench
