#pragma once

#include "mesher/boundary_complex.h"
#include "mesher/seeded_mesher.h"

namespace voroprobe
{

//! Counts by which means each piece of the mesh was found: met by probe(domain), begun at an isolated vertex,
//! or reached by refinement alone. Cost: O(faces).
void count_component_origins(const BoundaryComplex& complex, MeshingStatistics& statistics);

} // namespace voroprobe
