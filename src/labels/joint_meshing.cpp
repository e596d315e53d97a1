#include "labels/joint_meshing.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "certificate/mesh_pieces.h"
#include "labels/enclosed_background.h"
#include "labels/interface_fitting.h"
#include "labels/interface_meshing.h"
#include "labels/label_cavities.h"
#include "labels/label_partition.h"
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

//! `parts`: of the label that was meshed, in the order of those of the label it stands for.
void list_faults(const InterfaceMesh& interfaces, std::span<const std::uint32_t> parts,
                 const SurveyedLabel& surveyed, LabelMesh& label)
{
    const auto blame = [&](std::span<const std::uint32_t> faulty, const std::string& reason)
    {
        for (std::size_t n = 0; n < parts.size(); ++n)
            if (std::find(faulty.begin(), faulty.end(), parts[n]) != faulty.end())
                label.faults.push_back({surveyed.parts[n], reason});
    };
    blame(interfaces.missing_parts, "too small for the triangulation: no Delaunay cell has it");
    blame(interfaces.merged_parts, "joined with another part of the label");
}

//! Pieces that wind inward: what encloses something else than the label.
std::size_t count_inward(const TriangleMesh& mesh)
{
    const std::vector<MeshPiece> pieces = split_into_pieces(mesh).pieces;
    return static_cast<std::size_t>(std::count_if(
        pieces.begin(), pieces.end(), [](const MeshPiece& piece) { return piece.enclosed_volume < 0.0; }));
}

//! The label at `place`, which was meshed as the one at `place_meshed` of another survey.
LabelMesh gather(const LabelSurvey& survey, std::uint32_t place, const LabelSurvey& survey_meshed,
                 std::uint32_t place_meshed, const InterfaceMesh& interfaces, const Vec3& spacing,
                 double min_angle_deg)
{
    const SurveyedLabel& surveyed = survey.labels()[place];
    LabelMesh label{.label = place,
                    .mesh = mesh_of_label(interfaces, place_meshed + 1),
                    .faults = {},
                    .broken_promises = {}};
    const MeshTopology topology = analyze_topology(label.mesh);
    if (topology.boundary_edges + topology.misoriented_edges > 0)
        label.broken_promises.push_back(
            std::to_string(topology.boundary_edges) + " edges on one face only, " +
            std::to_string(topology.misoriented_edges) + " whose faces wind against each other");
    label.touching_edges = topology.non_manifold_edges;
    list_faults(interfaces, survey_meshed.labels()[place_meshed].parts, surveyed, label);
    label.cavities_expected = count_cavities(survey, place);
    label.cavities_meshed = count_inward(label.mesh);
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
    const LabelSurvey meshed = with_enclosed_background(survey, labels);
    std::vector<std::uint32_t> places(meshed.labels().size());
    std::iota(places.begin(), places.end(), 0);
    const LabelPartition partition(meshed, places, spacing);
    InterfaceMesh interfaces = mesh_interfaces(meshed, places, spacing, partition, criteria, progress);
    if (interfaces.status == MeshingStatus::kBudgetExhausted)
        throw Error(ExitStatus::kBudget, "the labels take more than " +
                                             count_text(criteria.max_vertices.value_or(0)) +
                                             " vertices at this size, distance and floor; none was meshed");
    if (interfaces.status != MeshingStatus::kDone)
        return;
    fit_volumes(interfaces, voxel_volumes(meshed, spacing),
                {.max_shift = kLargestShiftInVoxels * std::min({spacing.x, spacing.y, spacing.z})});
    for (std::uint32_t n = 0; n < labels.size(); ++n)
        done(gather(survey, labels[n], meshed, n, interfaces, spacing, criteria.min_facet_angle_deg));
}

} // namespace voroprobe
