#include "cli/summary.h"

#include <ostream>
#include <string_view>

#include <nlohmann/json.hpp>

#include "cli/certificate_report.h"
#include "cli/json_values.h"
#include "cli/process_summary.h"
#include "io/atomic_file.h"
#include "support/memory.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

std::string_view status_name(RunStatus status)
{
    switch (status)
    {
    case RunStatus::kDone:
        return "done";
    case RunStatus::kPartial:
        return "partial";
    case RunStatus::kIncomplete:
        return "incomplete";
    }
    return {};
}

std::string_view kind_name(InputKind kind)
{
    switch (kind)
    {
    case InputKind::kVolume:
        return "volume";
    case InputKind::kFormula:
        return "formula";
    case InputKind::kTriangleMesh:
        return "mesh";
    case InputKind::kPointCloud:
        return "points";
    }
    return {};
}

Json input_json(const MeshRun& run)
{
    const SurfaceInput& input = run.input;
    const bool is_volume = input.kind == InputKind::kVolume;
    const auto of_volume = [is_volume](const Json& value) { return is_volume ? value : Json(nullptr); };
    const bool is_file = !run.arguments.formula;
    return {{"kind", kind_name(input.kind)},
            {"path", is_file ? Json(run.arguments.input.string()) : Json(nullptr)},
            {"formula", value_or_null(run.arguments.formula)},
            {"domain", value_or_null(run.arguments.domain)},
            {"format", input.format},
            {"size", of_volume(input.lattice.size)},
            {"spacing", of_volume(json_of(input.lattice.spacing))},
            {"type", of_volume(input.stored_type)},
            {"min", of_volume(input.min)},
            {"max", of_volume(input.max)},
            {"warnings", input.warnings}};
}

std::string_view seeding_name(Seeding seeding, InputKind kind)
{
    switch (seeding)
    {
    case Seeding::kInventory:
        return kind == InputKind::kVolume ? "inventory" : "probe";
    case Seeding::kProbe:
        return "probe";
    case Seeding::kIsolated:
        return "isolated";
    case Seeding::kRandom:
        return "random";
    }
    return {};
}

//! How components are looked for.
Json finding_json(const MeshRun& run)
{
    const MeshingOptions& options = run.options;
    const bool random = options.seeding == Seeding::kRandom;
    const auto& seeds = run.arguments.finding.seeds;
    return {{"seeding", seeding_name(options.seeding, run.input.kind)},
            {"random_points", random ? Json(options.random_points) : Json(nullptr)},
            {"component_radius_mm", options.component_radius.value_or(options.reach_lower_bound)},
            {"components", value_or_null(options.component_count)},
            {"seeds", seeds ? Json(seeds->string()) : Json(nullptr)},
            {"theorem", run.arguments.finding.theorem},
            {"max_seconds", value_or_null(options.max_seconds)}};
}

Json parameters_json(const MeshRun& run)
{
    const MeshingOptions& options = run.options;
    const bool one_at_a_time = options.isolated_vertices == IsolatedVertices::kOneAtATime;
    const auto of_level = [&run](const Json& value)
    { return run.input.has_isovalue() ? value : Json(nullptr); };
    Json parameters{{"isovalue", of_level(run.input.isovalue.value)},
                    {"isovalue_source", of_level(run.input.isovalue.source)},
                    {"inside", of_level(run.input.inside == InsideIs::kAbove ? "above" : "below")},
                    {"border", options.close_border ? "closed" : "open"},
                    {"size_mm", options.max_facet_radius},
                    {"angle_deg", options.min_facet_angle_deg},
                    {"distance_mm", options.max_facet_distance.value()},
                    {"floor_mm", options.floor_radius},
                    {"reach_mm", options.reach_lower_bound},
                    {"isolated", one_at_a_time ? "one" : "all"},
                    {"max_vertices", value_or_null(run.arguments.max_vertices)},
                    {"frame_of_reference", frame_name(run.arguments.frame)},
                    {"seed", run.arguments.seed},
                    {"threads", value_or_null(run.arguments.threads)}};
    parameters.update(finding_json(run));
    return parameters;
}

Json mesh_json(const MeshRun& run)
{
    const MeshFacts& facts = run.facts;
    return {{"path", run.arguments.output.string()},
            {"vertices", facts.vertices},
            {"faces", facts.faces},
            {"components", facts.topology.components},
            {"closed", facts.topology.closed()},
            {"manifold", facts.topology.manifold()},
            {"oriented", facts.topology.oriented()},
            {"euler_characteristic", facts.topology.euler_characteristic},
            {"area_mm2", facts.area_mm2},
            {"volume_mm3", facts.volume_mm3},
            {"min_angle_deg", facts.angles.min_deg},
            {"mean_min_angle_deg", facts.angles.mean_min_deg},
            {"max_angle_deg", facts.angles.max_deg},
            {"faces_below_angle_bound", facts.faces_below_angle_bound},
            {"vertices_on_domain_border", run.vertices_on_border},
            {"box", json_of(run.output_box)}};
}

Json seeding_json(const MeshingStatistics& statistics)
{
    return {{"by_initialization", statistics.components_by_initialization},
            {"by_isolated_vertex", statistics.components_by_isolated_vertex},
            {"by_probing", statistics.components_by_probing},
            {"by_inventory", statistics.components_by_inventory},
            {"by_refinement", statistics.components_by_refinement},
            {"isolated_vertices_abandoned", statistics.isolated_vertices_abandoned},
            {"seeds_off_surface", statistics.seeds_off_surface},
            {"seeds_passed_over", statistics.seeds_passed_over},
            {"voronoi_cells_probed", statistics.cells_probed + statistics.cells_probed_at_once},
            {"probe_hits", statistics.probe_hits},
            {"probe_hits_passed_over", statistics.probe_hits_passed_over}};
}

Json work_json(const MeshingStatistics& statistics)
{
    return {{"insertions", statistics.insertions},
            {"insertions_side_by_side", statistics.insertions_side_by_side},
            {"stale_queue_entries", statistics.stale_queue_entries},
            {"facets_at_floor", statistics.facets_at_floor},
            {"uncovered_points", statistics.uncovered_points},
            {"cells_reconciled", statistics.cells_reconciled},
            {"crumbs_dissolved", statistics.crumbs_dissolved},
            {"necks_bridged", statistics.necks_bridged},
            {"handles_mended", statistics.handles_mended},
            {"cells_relabelled", statistics.cells_relabelled},
            {"contacts_separated", statistics.contacts_separated},
            {"contacts_carved", statistics.contacts_carved}};
}

} // namespace

std::string summary_json(const MeshRun& run)
{
    const MeshingStatistics& statistics = run.statistics;
    Json summary{{"version", VOROPROBE_VERSION},
                 {"status", status_name(run.status)},
                 {"input", input_json(run)},
                 {"parameters", parameters_json(run)},
                 {"mesh", mesh_json(run)},
                 {"seeding", seeding_json(statistics)},
                 {"oracle_queries",
                  {{"refinement", statistics.queries_refinement},
                   {"initialization", statistics.queries_initialization},
                   {"probing", statistics.queries_probing},
                   {"region_lookups", statistics.region_lookups}}},
                 {"work", work_json(statistics)},
                 {"timings_s",
                  {{"read", run.timings.read},
                   {"refinement", run.timings.refinement},
                   {"certificate", run.timings.certificate},
                   {"write", run.timings.write},
                   {"total", run.timings.total}}},
                 {"peak_memory_bytes", peak_memory_bytes()}};
    if (!run.steps.empty())
        summary["steps"] = steps_json(run.steps);
    if (run.certificate)
        summary["certificate"] = certificate_json(*run.certificate, shown_from_grid(run));
    return json_text(summary) + '\n';
}

void write_text(const std::filesystem::path& path, const std::string& text)
{
    write_atomically(path, {}, [&](std::ostream& out) { out << text; });
}

} // namespace voroprobe
