#pragma once

#include "mesher/meshing_options.h"
#include "mesher/refinement.h"
#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! Attempts initialize_component() makes for one vertex before it is abandoned.
inline constexpr std::uint8_t kMaxInitializations = 2;

//! initialize_component(P): gives the component of P a facet by adding two points near P. The second is a
//! crossing with the edges of a cube around P; the third a crossing with the edges of a square in the medial
//! plane of the first two, so that the triangle is nearly equilateral.
//!
//! The first attempt makes a large triangle (radius about half the size criterion), the second, for a vertex
//! that is isolated still, one of a quarter: this avoids the clusters of tiny triangles that starting with
//! persistent facets leaves. Both go on to smaller cubes, down to half the floor, until the points lie apart
//! from all vertices. Adds its queries to the statistics. Cost: 16 short queries per size tried. Source:
//! Feree & Alliez 2009, Sec. 4, with the second wish of their Sec. 5. Returns false where no second and third
//! point were found; the vertex then stays isolated.
bool initialize_component(VertexHandle first, const RestrictedDelaunay& restricted,
                          const MeshingOptions& options, Refinement& refinement,
                          MeshingStatistics& statistics);

} // namespace voroprobe
