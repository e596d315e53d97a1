#pragma once

#include "cli/mesh_arguments.h"

namespace voroprobe
{

//! `voroprobe mesh`: reads, meshes, checks, writes and reports. Returns where the mesh written is what was
//! promised. \throw Error with the exit status otherwise; README.md, "Exit status", says in which cases a
//! mesh was written.
void run_mesh_command(const MeshArguments& arguments);

} // namespace voroprobe
