#pragma once

#include "mesh/triangle_mesh.h"
#include "mesher/meshing_options.h"
#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! The odd facets as a mesh: closed, oriented outward, every edge on exactly two faces, every vertex with one
//! fan, no face crossing another, no unused vertex.
//!
//! The odd facets bound the union of the inside Delaunay cells. Where that union touches itself at an edge or
//! a vertex, the inside parts are taken apart: each gets its own copy of the vertex, moved by a hair to its
//! own side. Counts the exceptions in the statistics. Cost: O(Delaunay cells).
TriangleMesh extract_surface(const RestrictedDelaunay& restricted, const MeshingOptions& options,
                             MeshingStatistics& statistics);

} // namespace voroprobe
