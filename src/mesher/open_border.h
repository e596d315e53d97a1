#pragma once

#include "mesher/surface_extraction.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! Cuts off the caps that close the object where it leaves the domain. What is left is the surface itself,
//! with a rim on the border: its faces there are cut, or their corners moved along them. Where that would
//! make faces cross, the rim stays where the closed mesh cuts the corner between cap and surface. Vertices
//! whose faces are then several fans get a copy for each, moved by a hair into its fan. The mesh is a
//! manifold with a rim, no face of it crosses another, and no vertex is unused. \pre the surface is a closed
//! manifold, and no face crosses another. Cost: a query for each vertex and, near the border, some twenty for
//! each edge.
void open_border(const SurfaceOracle& oracle, ExtractedSurface& surface);

} // namespace voroprobe
