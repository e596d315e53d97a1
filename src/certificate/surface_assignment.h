#pragma once

#include <cstdint>
#include <vector>

#include "certificate/nearest_crossing.h"
#include "mesh/triangle_mesh.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! For each vertex the surface of the oracle's inventory it lies on: that of the nearest crossing that short
//! segments find around it. kNoSurface where there is none within `reach` (scan units), and for vertices on
//! no face. Meshes made by anyone: the vertices need not lie on the surface exactly. Frame: the oracle's.
//! Cost: a few queries per vertex, on all cores.
std::vector<SurfaceId> surface_of_vertices(const TriangleMesh& mesh, const SurfaceOracle& oracle,
                                           double reach, BorderCaps caps = BorderCaps::kCounted);

//! How much of a piece of the mesh lies on a surface.
struct Share
{
    std::uint32_t piece;
    SurfaceId surface;
    double area; //!< of a third of every face at a vertex on the surface; or of every face on it
};

//! For every piece the surfaces its vertices lie on, kNoSurface included: by piece, the largest share first.
std::vector<Share> shares_of_vertices(const TriangleMesh& mesh,
                                      const std::vector<std::uint32_t>& piece_of_face,
                                      const std::vector<SurfaceId>& surface_of_vertex);

//! The same where the surface of every face is known.
std::vector<Share> shares_of_faces(const TriangleMesh& mesh, const std::vector<std::uint32_t>& piece_of_face,
                                   const std::vector<SurfaceId>& surface_of_face);

} // namespace voroprobe
