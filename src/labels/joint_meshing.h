#pragma once

#include <functional>
#include <span>

#include "labels/label_meshing.h"

namespace voroprobe
{

//! Meshes labels together: smoothed as one partition (LabelPartition), with the same triangles on either side
//! of every interface (mesh_interfaces()). Each mesh is closed and oriented, and no two of them overlap.
//! Parts that are not there, or joined with another part of their label, are listed. `labels`: places in
//! survey.labels(). Hands the meshes over in the order of `labels`. On the thread that calls. Where the sink
//! asks to stop it returns without any. \throw Error (kBudget) as mesh_labels.
void mesh_labels_jointly(const LabelSurvey& survey, std::span<const std::uint32_t> labels,
                         const Vec3& spacing, const MeshingOptions& criteria, ProgressSink* progress,
                         const std::function<void(LabelMesh)>& done);

} // namespace voroprobe
