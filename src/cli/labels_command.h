#pragma once

#include "cli/mesh_arguments.h"

namespace voroprobe
{

//! `voroprobe mesh --labels`: each label of a segmentation becomes a mesh of its own, with its name and the
//! volume of its voxels. \pre arguments.label_map.wanted(). \throw Error
void run_labels_command(const MeshArguments& arguments);

} // namespace voroprobe
