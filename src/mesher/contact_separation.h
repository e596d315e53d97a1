#pragma once

#include <cstddef>
#include <vector>

#include "mesher/boundary_complex.h"
#include "mesher/pinched_edges.h"

namespace voroprobe
{

//! What separate_contacts() did.
struct ContactReport
{
    std::size_t separated = 0; //!< copies of vertices moved to their own side

    //! Vertices where copies still stand at one place, for want of a side where they would not cross a face.
    std::vector<VertexHandle> unseparated;
};

//! Moves the copies of a vertex apart by a hair, each to its own side, and `pinched`, the middle vertices of
//! pinched edges, so that a reader that makes equal points one still sees a manifold. No face crosses another
//! afterwards: checked with exact predicates around every move, which is halved where it fails.
//!
//! A copy may move where the side it moves to is its own: the inside (or outside) part there is bounded by
//! this umbrella alone, and the direction lies behind (before) every face of the umbrella.
ContactReport separate_contacts(const RestrictedDelaunay& restricted, BoundaryComplex& complex,
                                const std::vector<Displacement>& pinched);

} // namespace voroprobe
