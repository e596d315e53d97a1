#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesher/convex_outline.h"
#include "mesher/convex_region.h"
#include "mesher/delaunay.h"

namespace voroprobe
{

//! Whatever lies within `radius` of the axis, between the planes across it through its ends.
struct Cylinder
{
    Segment3 axis;
    double radius;
};

//! The Voronoi cell of a vertex. One object serves many cells in turn, to spare allocations.
class VoronoiCell
{
public:
    VoronoiCell();

    //! Takes the cell of a vertex that is no sentinel. Writes nothing to the triangulation: several threads
    //! may read it side by side. Cost: O(its Delaunay cells), some 25.
    void assign(VertexHandle vertex);

    [[nodiscard]] VertexHandle vertex() const { return vertex_; }
    [[nodiscard]] Point3 site() const { return position(vertex_); }

    //! The Delaunay cells around the vertex.
    [[nodiscard]] const std::vector<DelaunayCell>& star() const { return star_; }

    //! Their circumcenters, in the same order: the corners of the Voronoi cell.
    [[nodiscard]] const std::vector<Point3>& corners() const { return corners_; }

    //! Largest distance from the site to a point of the cell in the domain, at most: the size by which cells
    //! are probed. It never grows when points are inserted.
    [[nodiscard]] double size_within(const Box3& domain) const;

    //! Whether every corner lies in the domain.
    [[nodiscard]] bool is_within(const ProbedDomain& domain) const;

    //! A cylinder around the cell, along its longest extent.
    [[nodiscard]] Cylinder cylinder() const;

    //! The whole cell by its edges, with the domain's box as bounds. Replaces `outline`.
    void outline(const ProbedDomain& domain, ConvexOutline& outline) const;

    //! The cell clipped to the domain's box. Replaces `outline`.
    void clipped_outline(const ProbedDomain& domain, ConvexOutline& outline) const;

    //! The cell clipped to the domain, relative to the site.
    void clip_to(const ProbedDomain& domain, ConvexRegion& region) const;

private:
    std::uint32_t place_in_star(DelaunayCell delaunay_cell);
    void grow_places();
    void append_clipped_outline(const ProbedDomain& domain, ConvexOutline& outline) const;
    void append_bisectors(ConvexRegion& region) const;
    void append_edges_in(const Box3& box, ConvexRegion& region) const;
    [[nodiscard]] bool may_meet_edges_of(const Box3& box) const;

    VertexHandle vertex_;
    std::vector<DelaunayCell> star_;
    std::vector<std::uint32_t> places_; //!< hash table with open addresses: places in the star, or kNoPlace
    std::vector<Point3> corners_;
    std::vector<OutlineEdge> edges_; //!< between corners
};

} // namespace voroprobe
