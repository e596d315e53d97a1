#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"
#include "mesher/meshing_options.h"
#include "mesher/region_settlement.h"
#include "mesher/restricted_delaunay.h"
#include "mesher/seeded_mesher.h"

namespace voroprobe
{

//! A mesh that knows which surface of the oracle's inventory each face lies on.
struct ExtractedSurface
{
    TriangleMesh mesh;
    std::vector<SurfaceId> surface_of_face;
    std::vector<FoundPiece> pieces;
};

//! The odd facets as a mesh: closed (but for an open border), oriented outward, every edge on exactly two
//! faces, every vertex with one fan, no face crossing another, no unused vertex.
//!
//! The odd facets bound the union of the inside Delaunay cells, whose regions are settled. Where that union
//! touches itself it is taken apart: each part gets its own copy of the vertices, moved by a hair to its own
//! side (contact_separation.h). Where that fails, what was done for handles there is undone, and in the end
//! the inside around the contact given up. Counts the exceptions in the statistics. Cost: O(Delaunay cells).
//! Afterwards the triangulation is fit for nothing else.
ExtractedSurface extract_surface(const RestrictedDelaunay& restricted, RegionSettlement& settlement,
                                 const MeshingOptions& options, MeshingStatistics& statistics);

} // namespace voroprobe
