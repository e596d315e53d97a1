#pragma once

#include <cstddef>
#include <optional>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! When to stop; one of the two bounds at least.
struct DecimationOptions
{
    std::optional<std::size_t> faces = std::nullopt; //!< no more than so many are wanted, >= 4

    //! Points of the mesh that go are no farther from a face that stays near them; scan units, > 0.
    std::optional<double> max_distance = std::nullopt;

    //! Faces that change have no smaller angle, or none smaller than those they replace; degrees, in [0, 60).
    double min_angle_deg = 20.0;
};

//! A decimated mesh.
struct DecimationResult
{
    TriangleMesh mesh;
    std::size_t vertices_removed = 0;
    std::size_t vertices_locked = 0;    //!< because faces would have crossed around them
    std::size_t self_intersections = 0; //!< pairs of faces that locking did not avoid
};

//! Collapses edges in the order of the error they make (quadrics), never so that a face folds over, the
//! topology changes, or a bound is broken; the number of faces asked for may not be reached. Where faces
//! would come to cross, the vertices around are locked and all is begun anew. By OpenMesh. Deterministic.
//! \pre closed, manifold, oriented. \throw UsageError where no bound is given or one is out of its range.
//! Source: Garland & Heckbert 1997.
DecimationResult decimate(const TriangleMesh& mesh, const DecimationOptions& options);

} // namespace voroprobe
