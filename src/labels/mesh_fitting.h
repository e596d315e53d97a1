#pragma once

#include "mesh/triangle_mesh.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! Moves each vertex along its normal to where it leaves the surface's inside, at most `reach` away (scan
//! units, > 0); vertices that find no such place stay. For surfaces that differ by a shift of the level.
//! Nothing keeps faces from crossing: the mesh is to be checked anew. Cost: one segment query per vertex.
void move_onto_surface(TriangleMesh& mesh, const SurfaceOracle& oracle, double reach);

} // namespace voroprobe
