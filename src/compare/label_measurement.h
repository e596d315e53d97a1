#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "compare/label_contestant.h"
#include "compare/reference_surface.h"
#include "compare/view_mesh.h"

namespace voroprobe
{

//! What is true of the meshes of all labels together, with the names that to_json(Measurement) has: sums,
//! extremes and means over all faces or samples. Labels are looked at one by one, as meshes of neighbours
//! touch: self-intersections between two labels do not count.
//!
//! "surfaces" are the parts of the labels: present where parts_present() says so, else missing. Distances are
//! those to the halfway_surface() of each label that has a mesh. "labels" tells how far volumes are from
//! those of the voxels, and how many meshes are not closed and manifold.
//!
//! `meshes`: one for each label of the task, grid frame. Samples are shared out by area.
nlohmann::ordered_json measure_labels(const std::vector<TriangleMesh>& meshes, const LabelTask& task,
                                      const MeasuringOptions& options);

//! All meshes in one view, world; pieces are labels, by their place in the task.
ViewMesh make_label_view(const std::vector<TriangleMesh>& meshes, const LabelTask& task,
                         std::size_t most_faces);

} // namespace voroprobe
