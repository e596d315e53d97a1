#pragma once

#include <vector>

#include "certificate/certificate.h"
#include "cli/mesh_run.h"
#include "mesher/seeded_mesher.h"

namespace voroprobe
{

//! Takes the surfaces that the user does not want off the mesh. Does nothing where the surfaces of the input
//! cannot be listed, or the run is partial. \throw EmptySurfaceError where nothing would be left.
std::vector<DroppedSurface> drop_unwanted(MeshRun& run, MeshingResult& result);

//! The steps on the shape that the user asks for; relaxation keeps to the surface of the input. Whose face is
//! whose is not known after it. \throw Error kIncomplete where a step would break a promise.
void finish_shape(MeshRun& run, MeshingResult& result);

//! Holds the mesh against the scan, in run.certificate; where that cannot be done, as for drop_unwanted().
void certify_mesh(MeshRun& run, const MeshingResult& result, const std::vector<DroppedSurface>& dropped);

//! \throw UsageError where surfaces are to be left out of an input whose surfaces cannot be listed.
void check_selection(const MeshArguments& arguments, const SurfaceInput& input);

} // namespace voroprobe
