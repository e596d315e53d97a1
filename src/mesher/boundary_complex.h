#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "mesher/cell_table.h"
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
//! umbrellas have one copy for each. Copies start at the same place.
struct BoundaryComplex
{
    std::vector<BoundaryFace> faces;

    //! Of half-edge 3 f + k of boundary face f, where an end is pinched: the half-edge it is paired with.
    std::vector<std::uint32_t> partner;

    TriangleMesh mesh;                         //!< counter-clockwise seen from outside
    std::vector<std::uint32_t> origin_of_face; //!< for each mesh face the boundary face it is (a part of)
    std::vector<VertexHandle> vertex_of_copy;  //!< for each mesh vertex its own; null for one inside an edge
};

//! Whether the inside parts that meet at a pinched edge are one there; otherwise the outside parts are.
//! Different regions are never one; for the rest the side that holds the middle of the edge decides.
//! `delaunay_cell`: any that has the edge.
bool joined_at_edge(const RestrictedDelaunay& restricted, DelaunayCell delaunay_cell, VertexHandle a,
                    VertexHandle b);

//! The corners of the facet opposite each vertex of a positively oriented tetrahedron, counter-clockwise seen
//! from outside it.
inline constexpr int kOutwardCorners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

//! Corner k of a boundary face, counter-clockwise seen from outside; half-edge k runs from corner k to corner
//! k + 1.
inline VertexHandle corner(const BoundaryFace& face, std::size_t k)
{
    return face.inside->vertex(kOutwardCorners[face.index][k]);
}

//! Collects the odd facets and pairs them across each edge. Where more than two share an edge the oracle
//! decides which belong together (joined_at_edge). Needs VertexData::pinched. \pre The table is up to date.
//! Cost: O(Delaunay cells).
BoundaryComplex collect_boundary(const RestrictedDelaunay& restricted, const CellTable& table);

} // namespace voroprobe
