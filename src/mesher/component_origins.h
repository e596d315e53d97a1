#pragma once

#include "mesher/boundary_complex.h"
#include "mesher/seeded_mesher.h"

namespace voroprobe
{

//! Counts by which means each piece of the mesh was found: met by probe(domain), by probing a Voronoi cell,
//! begun at an isolated vertex, or reached by refinement alone; and the vertices, of those up to index
//! `vertices_inserted`, that are on no face. Cost: O(faces).
void count_component_origins(const BoundaryComplex& complex, std::size_t vertices_inserted,
                             MeshingStatistics& statistics);

} // namespace voroprobe
