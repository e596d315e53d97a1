#pragma once

#include "compare/peer_field.h"
#include "compare/stage_clock.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! The mesh that other contestants start from: FlyingEdges on a padded field, moved onto the border, wound
//! outward. A stage of its own.
TriangleMesh marching_cubes(const PeerField& padded_field, StageClock& clock);

} // namespace voroprobe
