#include "labels/joint_meshing.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "labels/cavity_labels.h"
#include "labels/interface_fitting.h"
#include "labels/interface_meshing.h"
#include "labels/label_cavities.h"
#include "labels/label_partition.h"
#include "labels/small_parts.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

//! A speck that meshing left half its radius needs as much.
constexpr double kLargestShiftInVoxels = 0.6;

//! By label; the background counts as none.
std::vector<double> voxel_volumes(const LabelSurvey& survey, const Vec3& spacing)
{
    std::vector<double> volumes{0.0};
    for (const SurveyedLabel& label : survey.labels())
        volumes.push_back(spacing.x * spacing.y * spacing.z * static_cast<double>(label.voxels));
    return volumes;
}

void list_faults(const InterfaceMesh& interfaces, const SurveyedLabel& surveyed, LabelMesh& label)
{
    const auto is_among = [](std::span<const std::uint32_t> parts, std::uint32_t part)
    { return std::binary_search(parts.begin(), parts.end(), part); };
    for (const std::uint32_t part : surveyed.parts)
    {
        if (is_among(interfaces.missing_parts, part))
            label.faults.push_back(
                {part, "too small for the triangulation: voxels of it have no Delaunay cell"});
        else if (is_among(interfaces.merged_parts, part))
            label.faults.push_back({part, "joined with another part of the label"});
        label.parts_in_pieces += is_among(interfaces.parts_in_pieces, part) ? 1 : 0;
    }
}

LabelMesh gather(const LabelSurvey& survey, std::uint32_t place, const InterfaceMesh& interfaces,
                 const Vec3& spacing, double min_angle_deg)
{
    const SurveyedLabel& surveyed = survey.labels()[place];
    LabelMesh label{
        .label = place, .mesh = mesh_of_label(interfaces, place + 1), .faults = {}, .broken_promises = {}};
    const MeshTopology topology = analyze_topology(label.mesh);
    if (topology.boundary_edges + topology.misoriented_edges > 0)
        label.broken_promises.push_back(
            std::to_string(topology.boundary_edges) + " edges on one face only, " +
            std::to_string(topology.misoriented_edges) + " whose faces wind against each other");
    label.touching_edges = topology.non_manifold_edges;
    list_faults(interfaces, surveyed, label);
    label.cavities_expected = count_cavities(survey, place);
    label.cavities_meshed = interfaces.cavities[place + 1];
    label.parts_meshed = surveyed.parts.size() - label.faults.size();
    label.voxel_volume = spacing.x * spacing.y * spacing.z * static_cast<double>(surveyed.voxels);
    label.mesh_volume = enclosed_volume(label.mesh);
    label.faces_below_angle = count_faces_below_angle(label.mesh, min_angle_deg);
    return label;
}

} // namespace

void mesh_labels_jointly(const LabelSurvey& survey, std::span<const std::uint32_t> labels,
                         const Vec3& spacing, const MeshingOptions& criteria, ProgressSink* progress,
                         const std::function<void(LabelMesh)>& done)
{
    const CavityLabels apart = label_cavities_apart(survey, labels);
    std::vector<std::uint32_t> places(apart.survey.labels().size());
    std::iota(places.begin(), places.end(), 0);
    LabelPartition partition(apart.survey, places, spacing);
    partition.balance(apart.survey, small_parts_alone(apart));
    InterfaceMesh interfaces = mesh_interfaces(survey, apart, spacing, partition, criteria, progress);
    if (interfaces.status == MeshingStatus::kBudgetExhausted)
        throw Error(ExitStatus::kBudget, "the labels take more than " +
                                             count_text(criteria.max_vertices.value_or(0)) +
                                             " vertices at this size, distance and floor; none was meshed");
    if (interfaces.status != MeshingStatus::kDone)
        return;
    fit_volumes(interfaces, voxel_volumes(apart.survey, spacing),
                {.max_shift = kLargestShiftInVoxels * std::min({spacing.x, spacing.y, spacing.z})});
    name_labels_of_map(interfaces, apart);
    for (const std::uint32_t label : labels)
        done(gather(survey, label, interfaces, spacing, criteria.min_facet_angle_deg));
}

} // namespace voroprobe
