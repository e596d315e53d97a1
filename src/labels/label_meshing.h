#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "geometry/vec3.h"
#include "labels/group_meshing.h"
#include "labels/label_survey.h"
#include "mesh/triangle_mesh.h"
#include "support/progress.h"

namespace voroprobe
{

//! The mesh of one label and what there is to tell of it.
struct LabelMesh
{
    std::uint32_t label = 0; //!< its place in LabelSurvey::labels()
    TriangleMesh mesh;       //!< closed, oriented outward; frame: the grid frame of the label map
    std::size_t parts_meshed = 0;
    std::vector<PartFault> faults; //!< parts that are not there, or are in pieces
    std::size_t parts_restored = 0;
    std::size_t cavities_expected = 0;
    std::size_t cavities_meshed = 0;
    double voxel_volume = 0.0; //!< cubic scan units, as the next
    double mesh_volume = 0.0;
    std::size_t faces_below_angle = 0;
    std::size_t parts_in_pieces = 0; //!< made jointly only: voxels that hang together at edges and corners
    std::size_t touching_edges = 0;  //!< on more than two faces; meshes made jointly only
    std::vector<std::string> broken_promises; //!< of the certificates, one line each

    [[nodiscard]] bool complete() const { return faults.empty() && broken_promises.empty(); }

    //! Of the volume, as a fraction of that of the voxels.
    [[nodiscard]] double volume_change() const { return mesh_volume / voxel_volume - 1.0; }
};

//! Meshes labels side by side and hands each over when it is done, one at a time, in no certain order, on any
//! thread; the meshes are the same for any number of threads. `labels`: places in LabelSurvey::labels().
//! `threads`: 0 for all there are. Largest labels first; in memory are those that are being meshed. Time
//! follows the samples in the boxes of the parts and the vertices. Progress may be reported from any thread,
//! one at a time. \throw whatever `done` throws; UsageError as mesh_surface; Error (kBudget) where a label
//! takes more vertices than the options allow. Where the sink asks to stop it returns without the labels that
//! are not done.
void mesh_labels(const LabelSurvey& survey, std::span<const std::uint32_t> labels, const Vec3& spacing,
                 const LabelMeshingOptions& options, std::size_t threads, ProgressSink* progress,
                 const std::function<void(LabelMesh)>& done);

} // namespace voroprobe
