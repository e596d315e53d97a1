#pragma once

#include "cli/mesh_run.h"
#include "mesher/seeded_mesher.h"

namespace voroprobe
{

//! Takes the surfaces that the user does not want off the mesh, then holds what is left against the scan, in
//! run.certificate. Does nothing where the surfaces of the input cannot be listed, or the run is partial.
//! \throw EmptySurfaceError where nothing would be left.
void drop_and_certify(MeshRun& run, MeshingResult& result);

//! \throw UsageError where surfaces are to be left out of an input whose surfaces cannot be listed.
void check_selection(const MeshArguments& arguments, const SurfaceInput& input);

} // namespace voroprobe
