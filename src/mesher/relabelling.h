#pragma once

#include <cstddef>
#include <vector>

#include "mesher/cell_table.h"
#include "mesher/meshing_options.h"
#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! Mends edges at which the surface pinches itself by moving single Delaunay cells to the other side of it:
//! those at the given vertices, and where that leads to. Sets VertexData::pinched of the given ones.
//!
//! The circumcenter of a sliver that lies along the surface may fall on either side of it, and a sliver on
//! the wrong side hangs on an edge. Any choice of sides gives a closed surface without crossings, so a cell
//! thinner than the floor may change sides where that leaves fewer pinched edges, umbrellas and angles below
//! the bound at its four vertices, taken together. Cells that agree with the oracle come first: they become
//! inside where the middle of the pinched edge is inside, and outside where it is outside. A cell that is a
//! piece (or a hole) by itself never changes. Returns the number of cells changed. Cost: O(vertices).
std::size_t relabel_pinched_cells(const RestrictedDelaunay& restricted, CellTable& table,
                                  const MeshingOptions& options, std::vector<VertexHandle> vertices);

//! Moves single Delaunay cells thinner than the floor, next to facets below the angle bound, to the other
//! side of the surface, where that leaves fewer such facets and nothing is pinched before or after: two
//! facets give place to the two others of the cell, or three to one. That changes neither the pieces of the
//! surface nor its handles. Where regions were repaired cells have become boundary that refinement never
//! looked at. Returns the number of changes. Cost: O(Delaunay cells).
std::size_t relabel_sharp_cells(const RestrictedDelaunay& restricted, CellTable& table,
                                const MeshingOptions& options);

} // namespace voroprobe
