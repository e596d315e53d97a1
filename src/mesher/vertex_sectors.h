#pragma once

#include <cstdint>
#include <vector>

#include "mesher/boundary_complex.h"

namespace voroprobe
{

//! The two parts of space that one umbrella at a singular vertex separates there.
struct UmbrellaSides
{
    std::uint32_t copy; //!< the umbrella's mesh vertex
    bool owns_inside;   //!< no other umbrella of the vertex bounds the inside part
    bool owns_outside;  //!< no other umbrella of the vertex bounds the outside part
};

//! Which side of each umbrella around `vertex` is its own. `faces`: the boundary faces with a corner there;
//! `copies`: for each the mesh vertex at that corner. Delaunay cells on the same side are one part where they
//! share a facet at the vertex; where the surface pinches itself along an edge the inside or the outside
//! cells around it are joined, as joined_at_edge() says.
std::vector<UmbrellaSides> find_umbrella_sides(const RestrictedDelaunay& restricted, VertexHandle vertex,
                                               const std::vector<BoundaryFace>& faces,
                                               const std::vector<std::uint32_t>& copies);

} // namespace voroprobe
