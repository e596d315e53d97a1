#include "cli/labels_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>

#include <nlohmann/json.hpp>

#include "cli/info_text.h"
#include "cli/json_values.h"
#include "cli/number_text.h"
#include "support/memory.h"

namespace voroprobe
{
namespace
{

using Json = nlohmann::ordered_json;

//! Labels of many that the table has.
constexpr std::size_t kMostRows = 40;

//! Volumes that change by more are counted, as a share.
constexpr double kVolumeBound = 0.02;

struct Totals
{
    std::size_t voxels = 0;
    std::size_t parts_expected = 0;
    std::size_t parts_meshed = 0;
    std::size_t parts_restored = 0;
    std::size_t parts_in_pieces = 0;
    std::size_t cavities_expected = 0;
    std::size_t cavities_meshed = 0;
    std::size_t incomplete = 0;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t faces_below_angle = 0;
    double voxel_volume = 0.0;
    double mesh_volume = 0.0;
    std::size_t beyond_bound = 0; //!< labels whose volume changed by more than kVolumeBound
    double largest_change = 0.0;  //!< of a label's volume, as a fraction
    const LabelOutcome* most_changed = nullptr;
};

Totals totals_of(const LabelsRun& run)
{
    Totals sum;
    for (const LabelOutcome& label : run.labels)
    {
        sum.voxels += label.voxels;
        sum.parts_expected += label.parts_expected;
        sum.parts_meshed += label.mesh.parts_meshed;
        sum.parts_restored += label.mesh.parts_restored;
        sum.parts_in_pieces += label.mesh.parts_in_pieces;
        sum.cavities_expected += label.mesh.cavities_expected;
        sum.cavities_meshed += label.mesh.cavities_meshed;
        sum.incomplete += label.mesh.complete() ? 0 : 1;
        sum.vertices += label.vertices;
        sum.faces += label.faces;
        sum.faces_below_angle += label.mesh.faces_below_angle;
        sum.voxel_volume += label.mesh.voxel_volume;
        sum.mesh_volume += label.mesh.mesh_volume;
        sum.beyond_bound += std::abs(label.mesh.volume_change()) > kVolumeBound ? 1 : 0;
        if (const double change = std::abs(label.mesh.volume_change()); !(change < sum.largest_change))
        {
            sum.largest_change = change;
            sum.most_changed = &label;
        }
    }
    return sum;
}

std::string smoothing_text(const LabelSmoothing& smoothing)
{
    switch (smoothing.method)
    {
    case SmoothingMethod::kNone:
        return "none";
    case SmoothingMethod::kGaussian:
        return "gaussian, sigma " + number_text(smoothing.sigma) + " mm";
    case SmoothingMethod::kAntialias:
        return "antialias";
    case SmoothingMethod::kJoint:
        return "joint, with shared interfaces";
    }
    return {};
}

std::string change_text(double change)
{
    std::ostringstream text;
    text << std::showpos << std::fixed << std::setprecision(2) << 100.0 * change;
    return text.str();
}

//! Meshes made jointly may lack some.
bool has_all_cavities(const LabelOutcome& label)
{
    return label.mesh.cavities_meshed >= label.mesh.cavities_expected;
}

std::string status_text(const LabelOutcome& label)
{
    if (!label.mesh.faults.empty())
        return count_text(label.mesh.faults.size()) + " of " + count_text(label.parts_expected) +
               " parts not whole";
    if (!label.mesh.broken_promises.empty())
        return label.mesh.broken_promises.front();
    if (has_all_cavities(label))
        return "whole";
    return "whole, " + count_text(label.mesh.cavities_expected - label.mesh.cavities_meshed) + " of " +
           count_text(label.mesh.cavities_expected) + " cavities open";
}

using Row = std::array<std::string, 8>;

Row row_of(const LabelOutcome& label)
{
    return {std::to_string(label.value),
            label.name,
            count_text(label.mesh.parts_meshed) + '/' + count_text(label.parts_expected),
            number_text(label.mesh.voxel_volume),
            number_text(label.mesh.mesh_volume),
            change_text(label.mesh.volume_change()),
            count_text(label.vertices),
            status_text(label)};
}

//! Names to the left, numbers to the right.
std::string table_text(const std::vector<Row>& rows)
{
    constexpr std::size_t kNameColumn = 1;
    std::array<std::size_t, std::tuple_size_v<Row>> width{};
    for (const Row& row : rows)
        for (std::size_t column = 0; column < row.size(); ++column)
            width[column] = std::max(width[column], row[column].size());
    std::string text;
    for (const Row& row : rows)
    {
        text += ' ';
        for (std::size_t column = 0; column + 1 < row.size(); ++column)
        {
            const std::string gap(width[column] - row[column].size(), ' ');
            text += ' ' + (column == kNameColumn ? row[column] + gap : gap + row[column]) + ' ';
        }
        text += ' ' + row.back() + '\n';
    }
    return text;
}

std::vector<const LabelOutcome*> shown_labels(const LabelsRun& run)
{
    std::vector<const LabelOutcome*> by_size;
    for (const LabelOutcome& label : run.labels)
        by_size.push_back(&label);
    std::stable_sort(by_size.begin(), by_size.end(),
                     [](const LabelOutcome* a, const LabelOutcome* b) { return a->voxels > b->voxels; });
    std::vector<const LabelOutcome*> shown;
    for (const LabelOutcome* label : by_size)
        if (shown.size() < kMostRows || !label->mesh.complete() || !has_all_cavities(*label))
            shown.push_back(label);
    std::sort(shown.begin(), shown.end(),
              [](const LabelOutcome* a, const LabelOutcome* b) { return a->value < b->value; });
    return shown;
}

std::string labels_table(const LabelsRun& run)
{
    std::vector<Row> rows{{"label", "name", "parts", "voxels mm3", "mesh mm3", "%", "vertices", "status"}};
    const auto shown = shown_labels(run);
    for (const LabelOutcome* label : shown)
        rows.push_back(row_of(*label));
    std::string text = '\n' + table_text(rows);
    if (shown.size() < run.labels.size())
        text += "  and " + count_text(run.labels.size() - shown.size()) +
                " smaller ones, all of them whole (--summary has every label)\n";
    return text;
}

Json color_json(const std::optional<Color>& color)
{
    return color ? Json{color->red, color->green, color->blue} : Json(nullptr);
}

Json label_json(const LabelOutcome& label)
{
    Json faults = Json::array();
    for (const PartFault& fault : label.mesh.faults)
        faults.push_back(fault.reason);
    return {{"layer", label.layer},
            {"label", label.value},
            {"name", label.name},
            {"color", color_json(label.color)},
            {"path", label.path.string()},
            {"status", label.mesh.complete() ? "done" : "incomplete"},
            {"parts_expected", label.parts_expected},
            {"parts_meshed", label.mesh.parts_meshed},
            {"parts_restored", label.mesh.parts_restored},
            {"parts_in_pieces", label.mesh.parts_in_pieces},
            {"part_faults", faults},
            {"broken_promises", label.mesh.broken_promises},
            {"cavities_expected", label.mesh.cavities_expected},
            {"cavities_meshed", label.mesh.cavities_meshed},
            {"voxels", label.voxels},
            {"voxel_volume_mm3", label.mesh.voxel_volume},
            {"mesh_volume_mm3", label.mesh.mesh_volume},
            {"volume_change_percent", 100.0 * label.mesh.volume_change()},
            {"vertices", label.vertices},
            {"faces", label.faces},
            {"touching_edges", label.mesh.touching_edges},
            {"faces_below_angle_bound", label.mesh.faces_below_angle}};
}

std::string pieces_text(const Totals& sum)
{
    if (sum.parts_in_pieces == 0)
        return {};
    return "; " + count_text(sum.parts_in_pieces) +
           " in several pieces, where voxels hang together at edges and corners only";
}

Json parameters_json(const LabelsRun& run)
{
    const MeshingOptions& criteria = run.options.criteria;
    return {{"smoothing", smoothing_text(run.options.smoothing)},
            {"size_mm", criteria.max_facet_radius},
            {"angle_deg", criteria.min_facet_angle_deg},
            {"distance_mm", criteria.max_facet_distance.value()},
            {"floor_mm", criteria.floor_radius},
            {"reach_mm", criteria.reach_lower_bound},
            {"frame_of_reference", frame_name(run.arguments.frame)},
            {"threads", run.threads}};
}

std::string criteria_text(const MeshingOptions& options)
{
    return "size " + number_text(options.max_facet_radius) + " mm, angle " +
           number_text(options.min_facet_angle_deg) + " deg, distance " +
           number_text(options.max_facet_distance.value()) + " mm, floor " +
           number_text(options.floor_radius) + " mm";
}

} // namespace

std::string labels_report(const LabelsRun& run)
{
    const Totals sum = totals_of(run);
    return info_line("input", run.arguments.input.string()) +
           info_line("", size_text(run.map.lattice.size) + " voxels of " +
                             triple_text(run.map.lattice.spacing) + " mm, " + run.map.stored_type + " (" +
                             run.map.format + "), " + count_text(run.map.label_count()) + " labels") +
           info_line("smoothing", smoothing_text(run.options.smoothing)) +
           info_line("criteria", criteria_text(run.options.criteria)) + labels_table(run) + '\n' +
           info_line("labels", count_text(run.labels.size()) + " meshed, " + count_text(sum.incomplete) +
                                   " not as promised") +
           info_line("parts", count_text(sum.parts_expected) + " in the label map (26 neighbours), " +
                                  count_text(sum.parts_meshed) + " meshed, " +
                                  count_text(sum.parts_restored) + " of them kept from being smoothed away" +
                                  pieces_text(sum)) +
           info_line("cavities", count_text(sum.cavities_expected) + " in the label map, " +
                                     count_text(sum.cavities_meshed) + " meshed") +
           info_line("volume", number_text(sum.voxel_volume) + " mm3 of voxels, " +
                                   number_text(sum.mesh_volume) +
                                   " mm3 of meshes; largest change of a label " +
                                   change_text(sum.most_changed->mesh.volume_change()) + " % (" +
                                   sum.most_changed->name + "), " + count_text(sum.beyond_bound) +
                                   " by more than 2 %") +
           info_line("meshes", count_text(sum.vertices) + " vertices, " + count_text(sum.faces) + " faces, " +
                                   count_text(sum.faces_below_angle) + " below " +
                                   number_text(run.options.criteria.min_facet_angle_deg) + " deg") +
           info_line("time", "read " + seconds_text(run.timings.read) + ", meshing " +
                                 seconds_text(run.timings.refinement) + " on " + count_text(run.threads) +
                                 " threads, total " + seconds_text(run.timings.total) + "; peak memory " +
                                 bytes_text(peak_memory_bytes())) +
           info_line("written", run.arguments.output.string());
}

std::string labels_summary_json(const LabelsRun& run)
{
    const Totals sum = totals_of(run);
    Json labels = Json::array();
    for (const LabelOutcome& label : run.labels)
        labels.push_back(label_json(label));
    const Json summary{
        {"version", VOROPROBE_VERSION},
        {"status", run.complete() ? "done" : "incomplete"},
        {"input",
         {{"kind", "labels"},
          {"path", run.arguments.input.string()},
          {"format", run.map.format},
          {"size", run.map.lattice.size},
          {"type", run.map.stored_type},
          {"layers", run.map.layers.size()},
          {"labels", run.map.label_count()},
          {"parts", run.map.part_count()},
          {"warnings", run.map.warnings}}},
        {"parameters", parameters_json(run)},
        {"totals",
         {{"labels", run.labels.size()},
          {"labels_incomplete", sum.incomplete},
          {"parts_expected", sum.parts_expected},
          {"parts_meshed", sum.parts_meshed},
          {"parts_restored", sum.parts_restored},
          {"parts_in_pieces", sum.parts_in_pieces},
          {"cavities_expected", sum.cavities_expected},
          {"cavities_meshed", sum.cavities_meshed},
          {"voxel_volume_mm3", sum.voxel_volume},
          {"mesh_volume_mm3", sum.mesh_volume},
          {"largest_volume_change_percent", 100.0 * sum.largest_change},
          {"labels_beyond_2_percent", sum.beyond_bound},
          {"vertices", sum.vertices},
          {"faces", sum.faces},
          {"faces_below_angle_bound", sum.faces_below_angle}}},
        {"labels", labels},
        {"timings_s",
         {{"read", run.timings.read}, {"meshing", run.timings.refinement}, {"total", run.timings.total}}},
        {"peak_memory_bytes", peak_memory_bytes()}};
    return json_text(summary) + '\n';
}

} // namespace voroprobe
