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

//! Of the surfaces of the oracle's inventory, as their meshes are by the regions of the Delaunay cells.
struct MeshedSurfaces
{
    std::vector<long> doubled_euler;    //!< by surface
    std::vector<SurfacePoint> vertices; //!< of the mesh, once for each surface that they are on
    double longest_side = 0.0;          //!< of a facet, scan units
};

//! Needs VertexData::pinched. Cost: O(Delaunay cells).
MeshedSurfaces find_meshed_surfaces(const RestrictedDelaunay& restricted, const CellTable& table);

} // namespace voroprobe
