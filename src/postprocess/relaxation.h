#pragma once

#include <cstddef>
#include <limits>

#include "mesh/triangle_mesh.h"
#include "postprocess/angle_repair.h"
#include "postprocess/bounding_surface.h"

namespace voroprobe
{

//! How far relaxation is to go.
struct RelaxationOptions
{
    //! What the smallest angle is to be, degrees, in [0, 40]. Faces with less are told.
    double target_angle_deg = 33.0;

    //! Scan units, > 0: where faces have long been beyond the bound the surface does not hold what is
    //! annealed; it ends no farther from where it was, and no farther than four times the bound.
    double max_shift = std::numeric_limits<double>::infinity();

    //! Passes over the whole mesh before that.
    int sweeps = 8;
};

//! A relaxed mesh, and what that took.
struct RelaxationResult
{
    TriangleMesh mesh;
    std::size_t vertices_moved = 0; //!< of those that are left
    std::size_t edges_flipped = 0;
    std::size_t edges_collapsed = 0;
    std::size_t edges_split = 0;
    ShortFaces short_faces;             //!< that could not be improved enough
    std::size_t vertices_held = 0;      //!< in the sweeps, where the surface all but touches itself
    std::size_t self_intersections = 0; //!< pairs of faces that could not be avoided
};

//! Raises the angles of a closed mesh and keeps its surface: vertices move along the surface towards the
//! middle of their neighbours and are projected back, edges flip where that raises the smallest angle; then
//! every face below the target gets the best of moves, flips, collapses and splits around it, and what that
//! leaves is annealed. The topology stays as it is. No face comes to lie farther from the surface than the
//! bound, but for as many as lay beyond it before, and none of these farther than the farthest near it did.
//! Where faces were beyond the bound already, vertices leave the surface, within the largest shift.
//! Where faces would come to cross, what lies around is left to exact checks. Deterministic. \pre closed,
//! manifold. \throw UsageError where an option is out of its range. Cost: about 0.1 ms a face. Source of the
//! sweeps: Botsch & Kobbelt 2004, "A remeshing approach to multiresolution modeling".
RelaxationResult relax(const TriangleMesh& mesh, const BoundingSurface& surface,
                       const RelaxationOptions& options = {});

} // namespace voroprobe
