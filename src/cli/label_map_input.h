#pragma once

#include <vector>

#include "cli/labels_run.h"
#include "cli/mesh_arguments.h"

namespace voroprobe
{

//! \throw UsageError where an option does not go with --labels.
void check_label_arguments(const MeshArguments& arguments);

//! Reads and surveys the label map. \throw as read_volume and LabelSurvey; EmptySurfaceError where it has no
//! label.
LabelMap read_label_map(const MeshArguments& arguments);

//! The labels asked for, with their names, in ascending order. \throw UsageError where one is not there, with
//! those that are, or where there are more than allowed; InputError as read_label_table.
std::vector<LabelOutcome> chosen_labels(const MeshArguments& arguments, const LabelMap& map);

//! What labels are to satisfy; `threads` share the memory there is.
LabelMeshingOptions label_meshing_options(const MeshArguments& arguments, const LabelMap& map,
                                          std::size_t threads);

} // namespace voroprobe
