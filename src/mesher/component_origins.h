#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/boundary_complex.h"
#include "mesher/seeded_mesher.h"

namespace voroprobe
{

//! By which means each piece of the mesh was found: met by probe(domain), by probing a Voronoi cell, begun at
//! an isolated vertex, or reached by refinement alone. `surface_of_face`: as MeshingResult has it. Cost:
//! O(faces).
std::vector<FoundPiece> find_pieces(const BoundaryComplex& complex,
                                    std::span<const SurfaceId> surface_of_face);

//! The number of vertices, of those up to index `vertices_inserted`, that are on no face.
std::size_t count_abandoned_vertices(const BoundaryComplex& complex, std::size_t vertices_inserted);

} // namespace voroprobe
