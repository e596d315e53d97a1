#pragma once

// CGAL's triangulation as the mesher uses it. Internal to src/mesher: no other folder includes this header.

#include <array>
#include <cstdint>
#include <limits>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "geometry/vec3.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! Index into RestrictedDelaunay's table of restricted facets.
using FacetId = std::uint32_t;
inline constexpr FacetId kNoFacet = std::numeric_limits<FacetId>::max();
inline constexpr FacetId kUnqueriedFacet =
    kNoFacet - 1; //!< the oracle was not asked yet; facet ids run below

//! How a vertex came into the triangulation.
enum class VertexOrigin : std::uint8_t
{
    kSentinel,       //!< far beyond the domain; makes every dual edge a segment
    kProbe,          //!< hit by probe(domain), or a seed
    kCellProbe,      //!< hit by probing a Voronoi cell
    kInitialization, //!< second or third point of initialize_component()
    kInventory,      //!< on a surface that had no facet
    kRefinement      //!< center of a bad facet's surface Delaunay ball
};

//! Vertices with VertexOrigin::kSentinel; their indices come first.
inline constexpr int kSentinelCount = 4;

struct VertexData
{
    std::uint32_t index = 0;        //!< in order of insertion, sentinels first
    SurfaceId surface = kNoSurface; //!< that the vertex lies on
    VertexOrigin origin = VertexOrigin::kRefinement;
    std::uint8_t initializations = 0; //!< times initialize_component() was called for it
    bool pinched = true;              //!< its odd facets were not one umbrella, or none, when last looked at
    bool cell_probed = false;         //!< its Voronoi cell was probed, or is part of cells that were
    bool umbrella_unchecked = false;  //!< its restricted facets changed since its umbrella was last looked at
};

struct DelaunayCellData
{
    Point3 circumcenter;          //!< the dual Voronoi vertex
    Region region = kOuterRegion; //!< of the circumcenter, until repaired
    std::uint32_t scratch = 0;    //!< the number that CellTable gave the cell
    std::array<FacetId, 4> facet{kNoFacet, kNoFacet, kNoFacet,
                                 kNoFacet}; //!< restricted facet opposite each vertex
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using DelaunayVertexBase = CGAL::Triangulation_vertex_base_with_info_3<VertexData, Kernel>;
using DelaunayCellBase =
    CGAL::Triangulation_cell_base_with_info_3<DelaunayCellData, Kernel,
                                              CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Triangulation = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<DelaunayVertexBase, DelaunayCellBase>>;
using VertexHandle = Triangulation::Vertex_handle;
using DelaunayCell = Triangulation::Cell_handle;

inline Point3 position(const VertexHandle& vertex)
{
    return {vertex->point().x(), vertex->point().y(), vertex->point().z()};
}

inline std::array<Point3, 4> corner_positions(DelaunayCell delaunay_cell)
{
    return {position(delaunay_cell->vertex(0)), position(delaunay_cell->vertex(1)),
            position(delaunay_cell->vertex(2)), position(delaunay_cell->vertex(3))};
}

//! Has the memory of a cell fetched that is looked at soon.
inline void prefetch(DelaunayCell delaunay_cell)
{
    constexpr std::size_t kCacheLineBytes = 64;
    const char* begin = reinterpret_cast<const char*>(&*delaunay_cell);
    for (std::size_t offset = 0; offset < sizeof(*delaunay_cell); offset += kCacheLineBytes)
        __builtin_prefetch(begin + offset);
}

//! Whether the circumcenter lies inside; the Delaunay cell then counts as inside.
inline bool inside(DelaunayCell delaunay_cell)
{
    return is_inside(delaunay_cell->info().region);
}

//! Whether the facet opposite vertex i separates inside from outside.
inline bool separates_sides(DelaunayCell delaunay_cell, int i)
{
    return inside(delaunay_cell) != inside(delaunay_cell->neighbor(i));
}

//! The index in `next` of the vertex opposite the facet that it shares with a cell, the one opposite vertex i
//! of the cell. Reads vertices only, which cells keep; other threads may be giving `next` other neighbours.
inline int mirror_index(DelaunayCell delaunay_cell, int i, DelaunayCell next)
{
    const VertexHandle a = delaunay_cell->vertex((i + 1) & 3);
    const VertexHandle b = delaunay_cell->vertex((i + 2) & 3);
    const VertexHandle c = delaunay_cell->vertex((i + 3) & 3);
    int index = 0;
    while (next->vertex(index) == a || next->vertex(index) == b || next->vertex(index) == c)
        ++index;
    return index;
}

inline Kernel::Point_3 cgal_point(const Point3& p)
{
    return {p.x, p.y, p.z};
}

} // namespace voroprobe
