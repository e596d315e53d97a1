#pragma once

#include <map>
#include <vector>

#include "mesher/cell_table.h"
#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! Twice the Euler characteristics of surfaces, or parts of them: in a closed triangle mesh three half-edges
//! belong to a face, so that it is twice the vertices less the faces.
using DoubledEuler = std::map<SurfaceId, long>;

//! What the Delaunay cells' own facets and the umbrellas at their corners contribute to the surfaces' meshes:
//! everything that depends on the regions of these cells. Umbrellas are those of collect_boundary().
DoubledEuler doubled_euler_around(const RestrictedDelaunay& restricted,
                                  const std::vector<DelaunayCell>& delaunay_cells);

//! Of each surface of the oracle's inventory, as its mesh has it by the regions of the Delaunay cells. Needs
//! VertexData::pinched. Cost: O(Delaunay cells).
std::vector<long> doubled_euler_of_surfaces(const RestrictedDelaunay& restricted, const CellTable& table);

} // namespace voroprobe
