#pragma once

#include <cstddef>
#include <optional>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! What to mend, and what it took.
struct RepairOptions
{
    //! Holes with a longer rim stay open, scan units. Unset: all are closed.
    std::optional<double> max_hole_rim = std::nullopt;
};
struct RepairResult
{
    TriangleMesh mesh;
    std::size_t faces_dropped =
        0; //!< without area by their corners, or over the same corners as an earlier one
    std::size_t vertices_split = 0; //!< so that faces around each are one fan, and no edge has three
    std::size_t faces_turned = 0;   //!< to wind like their neighbours, or outward
    std::size_t holes_closed = 0;
    std::size_t holes_left = 0;
};

//! Mends meshes that others made: takes out degenerate and double faces and vertices on no face, splits
//! vertices and edges that are not manifold, winds faces alike and outward (cavities inward), and closes
//! holes with flat faces. Gaps between faces whose corners are not equal are not sewn, and faces that cross
//! are left: a check tells. \pre faces name existing vertices. By CGAL's polygon mesh processing.
RepairResult repair(const TriangleMesh& mesh, const RepairOptions& options = {});

} // namespace voroprobe
