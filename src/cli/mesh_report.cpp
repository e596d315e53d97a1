#include "cli/mesh_report.h"

#include <cmath>

#include "cli/certificate_report.h"
#include "cli/info_text.h"
#include "cli/number_text.h"
#include "support/memory.h"

namespace voroprobe
{

namespace
{

std::string input_text(const SurfaceInput& input)
{
    if (input.kind != InputKind::kVolume)
        return input.description;
    return size_text(input.lattice.size) + " voxels of " + triple_text(input.lattice.spacing) + " mm, " +
           input.stored_type + " (" + input.format + "), values " + number_text(input.min) + " to " +
           number_text(input.max);
}

std::string surface_text(const MeshRun& run)
{
    return number_text(run.input.isovalue.value) + " (" + run.input.isovalue.source + "), inside " +
           (run.input.inside == InsideIs::kAbove ? "above" : "below") + ", border " +
           (run.arguments.border == BorderFaces::kClosed ? "closed" : "open");
}

std::string criteria_text(const MeshingOptions& options)
{
    return "size " + number_text(options.max_facet_radius) + " mm, angle " +
           number_text(options.min_facet_angle_deg) + " deg, distance " +
           number_text(options.max_facet_distance.value()) + " mm, floor " +
           number_text(options.floor_radius) + " mm, reach " + number_text(options.reach_lower_bound) + " mm";
}

std::string seeding_text(const MeshRun& run)
{
    const MeshingStatistics& statistics = run.statistics;
    return count_text(run.facts.topology.components) + " found; begun at: first probe " +
           count_text(statistics.components_by_initialization) + ", isolated vertices " +
           count_text(statistics.components_by_isolated_vertex) + ", cell probing " +
           count_text(statistics.components_by_probing) + ", inventory " +
           count_text(statistics.components_by_inventory) + ", refinement alone " +
           count_text(statistics.components_by_refinement);
}

std::string topology_text(const MeshTopology& topology)
{
    return std::string(topology.closed() ? "closed" : "not closed") + ", " +
           (topology.manifold() ? "manifold" : "not manifold") + ", " +
           (topology.oriented() ? "oriented" : "not oriented") + ", Euler characteristic " +
           std::to_string(topology.euler_characteristic);
}

std::string angles_text(const MeshRun& run)
{
    return "smallest " + number_text(run.facts.angles.min_deg) + " deg, mean of the faces' smallest " +
           number_text(run.facts.angles.mean_min_deg) + " deg, " +
           count_text(run.facts.faces_below_angle_bound) + " faces below " +
           number_text(run.options.min_facet_angle_deg) + " deg";
}

std::string box_text(const Box3& box, OutputFrame frame)
{
    // A coordinate that is zero but for rounding would be shown with all its noise.
    const double rounding = 1e-12 * box.diagonal();
    const auto shown = [&](double x) { return number_text(std::abs(x) < rounding ? 0.0 : x); };
    const auto range = [&](std::size_t axis) { return shown(box.min[axis]) + " .. " + shown(box.max[axis]); };
    return "x " + range(0) + ", y " + range(1) + ", z " + range(2) + ' ' + std::string(frame_unit(frame)) +
           " (" + std::string(frame_name(frame)) + ')';
}

std::string times_text(const RunTimings& timings)
{
    return "read " + seconds_text(timings.read) + ", refinement " + seconds_text(timings.refinement) +
           ", certificate " + seconds_text(timings.certificate) + ", write " + seconds_text(timings.write) +
           ", total " + seconds_text(timings.total) + "; peak memory " + bytes_text(peak_memory_bytes());
}

} // namespace

std::string mesh_report(const MeshRun& run)
{
    const MeshFacts& facts = run.facts;
    return info_line("input", run.arguments.formula.value_or(run.arguments.input.string())) +
           info_line("", input_text(run.input)) +
           (run.input.has_isovalue() ? info_line("isovalue", surface_text(run)) : std::string()) +
           info_line("criteria", criteria_text(run.options)) + info_line("pieces", seeding_text(run)) +
           step_lines(run.steps) +
           (run.certificate ? certificate_lines(*run.certificate, shown_from_grid(run)) : std::string()) +
           info_line("mesh",
                     count_text(facts.vertices) + " vertices, " + count_text(facts.faces) + " faces") +
           info_line("", topology_text(facts.topology)) + info_line("angles", angles_text(run)) +
           info_line("area",
                     number_text(facts.area_mm2) + " mm2, volume " + number_text(facts.volume_mm3) + " mm3") +
           info_line("box", box_text(run.output_box, run.arguments.frame)) +
           info_line("time", times_text(run.timings)) +
           info_line("written",
                     run.arguments.output.string() + (run.status == RunStatus::kPartial ? " (partial)" : ""));
}

} // namespace voroprobe
