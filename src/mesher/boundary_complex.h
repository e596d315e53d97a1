#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! An odd facet seen from its inside Delaunay cell.
struct BoundaryFace
{
    DelaunayCell inside;
    int index; //!< the facet is opposite this vertex of `inside`
};

//! The odd facets as a combinatorial 2-manifold: vertices of the triangulation around which they form several
//! umbrellas, as seen from the inside, have one copy for each. Copies start at the same place.
struct BoundaryComplex
{
    std::vector<BoundaryFace> faces;
    std::vector<std::uint32_t> partner; //!< of half-edge 3 f + k of boundary face f, where an end is pinched
    TriangleMesh mesh;                  //!< counter-clockwise seen from outside
    std::vector<std::uint32_t> origin_of_face; //!< for each mesh face the boundary face it is (a part of)
    std::vector<VertexHandle>
        vertex_of_copy; //!< for each mesh vertex its Delaunay vertex; null for one inside an edge
};

//! Whether the inside parts that meet at a pinched edge are one there: its middle lies inside. Otherwise the
//! outside parts are.
bool joined_at_edge(const SurfaceOracle& oracle, VertexHandle a, VertexHandle b);

//! Corner k of a boundary face, counter-clockwise seen from outside; half-edge k runs from corner k to corner
//! k + 1.
VertexHandle corner(const BoundaryFace& face, std::size_t k);

//! Collects the odd facets and pairs them across each edge through the inside cells between them, which takes
//! inside parts that touch at an edge or a vertex apart. Cost: O(Delaunay cells).
BoundaryComplex collect_boundary(const RestrictedDelaunay& restricted);

} // namespace voroprobe
