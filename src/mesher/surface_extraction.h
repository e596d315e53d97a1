#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"
#include "mesher/meshing_options.h"
#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! A mesh that knows which surface of the oracle's inventory each face lies on.
struct ExtractedSurface
{
    TriangleMesh mesh;
    std::vector<SurfaceId> surface_of_face;
};

//! The odd facets as a mesh: closed (but for an open border), oriented outward, every edge on exactly two
//! faces, every vertex with one fan, no face crossing another, no unused vertex.
//!
//! The odd facets bound the union of the inside Delaunay cells. Where that union touches itself at an edge,
//! cells thinner than the floor change sides if that mends it (relabelling.h); what still touches is taken
//! apart: each part gets its own copy of the vertices, moved by a hair to its own side
//! (contact_separation.h). Counts the exceptions in the statistics. Cost: O(Delaunay cells). Afterwards the
//! triangulation is fit for nothing else.
ExtractedSurface extract_surface(RestrictedDelaunay& restricted, const MeshingOptions& options,
                                 MeshingStatistics& statistics);

} // namespace voroprobe
