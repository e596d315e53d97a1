#pragma once

#include <cstdint>
#include <vector>

#include "mesher/boundary_complex.h"

namespace voroprobe
{

//! How far a vertex is moved at a contact, as a fraction of the shortest edge there: far above the rounding
//! of 32-bit coordinates, far below what could be seen.
inline constexpr double kHairPerEdge = 0.01;

//! A vertex that has to leave the place it shares with others.
struct Displacement
{
    std::uint32_t vertex; //!< of the mesh
    VertexHandle
        near;    //!< the faces it could come to cross have all their corners at this vertex or its neighbors
    Point3 from; //!< where it stands together with others
    Vec3 direction; //!< unit vector to its own side
    double length;  //!< of the move, scan units
};

//! Cuts the edges that more than two faces still share after collect_boundary(), because one umbrella passes
//! them several times at both ends: of the wedges at such an edge all but the widest get a middle
//! vertex of their own, to be moved into the wedge. Afterwards every edge has exactly two faces. Returns the
//! moves. Cost: O(faces).
std::vector<Displacement> split_pinched_edges(const RestrictedDelaunay& restricted, BoundaryComplex& complex);

} // namespace voroprobe
