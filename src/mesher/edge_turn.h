#pragma once

#include "mesher/delaunay.h"

namespace voroprobe
{

//! A facet of the triangulation: the one opposite vertex `index` of a Delaunay cell.
struct FacetOfCell
{
    DelaunayCell delaunay_cell;
    int index;
};

//! The odd facet met next when turning around the edge (a, b) from `start`, which is entered through the
//! facet opposite its vertex `entered_at`, through Delaunay cells on its side of the surface; seen from that
//! side. \pre the facet entered through is odd.
inline FacetOfCell next_odd_facet(DelaunayCell start, int entered_at, VertexHandle a, VertexHandle b)
{
    DelaunayCell delaunay_cell = start;
    while (true)
    {
        const int leave_at = 6 - entered_at - delaunay_cell->index(a) - delaunay_cell->index(b);
        const DelaunayCell next = delaunay_cell->neighbor(leave_at);
        if (inside(next) != inside(start))
            return {delaunay_cell, leave_at};
        entered_at = next->index(delaunay_cell);
        delaunay_cell = next;
    }
}

} // namespace voroprobe
