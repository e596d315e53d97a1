#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.h"
#include "postprocess/surface_projection.h"

namespace voroprobe
{

//! How far relaxation is to go.
struct RelaxationOptions
{
    //! Changed faces have their middle no farther from the surface, or no farther than the faces they
    //! replace; scan units, > 0.
    double max_distance;

    //! Faces with a smaller angle are worked on one by one, degrees, in [0, 40].
    double goal_angle_deg = 34.0;

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
    std::size_t faces_below_goal = 0; //!< that could not be improved
    std::size_t vertices_delicate =
        0; //!< where the surface all but touches itself: changed with exact checks only
    std::size_t self_intersections = 0; //!< pairs of faces that could not be avoided
};

//! Raises the angles of a closed mesh and keeps its surface: vertices move along the surface towards the
//! middle of their neighbours and are projected back, edges flip where that raises the smallest angle; then
//! every face below the goal gets the best of moves, flips, collapses and splits around it. The topology
//! stays as it is. Where faces would come to cross, the vertices around are held and all is begun anew.
//! Deterministic. \pre closed, manifold. \throw UsageError where an option is out of its range. Cost: about
//! 0.1 ms a face. Source of the sweeps: Botsch & Kobbelt 2004, "A remeshing approach to multiresolution
//! modeling".
RelaxationResult relax(const TriangleMesh& mesh, const SurfaceProjection& projection,
                       const RelaxationOptions& options);

} // namespace voroprobe
