#pragma once

#include <array>
#include <vector>

#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! Corners of facets of the mesh.
using FacetCorners = std::vector<std::array<Point3, 3>>;

//! The odd facets of the Delaunay cells that are nowhere farther than `reach` from the surface, as far as
//! their surface Delaunay balls tell (center of the ball to circumcenter): they stand for a surface that is
//! known within their reach. Replaces `facets`; a facet may be in it twice.
void collect_close_facets(const RestrictedDelaunay& restricted,
                          const std::vector<DelaunayCell>& delaunay_cells, double reach,
                          FacetCorners& facets);

//! Whether one of the facets is nearer to the point than `reach`.
bool is_near(const FacetCorners& facets, const Point3& p, double reach);

//! What the mesh around a vertex explains: crossings near the vertex, or near one of the close facets of its
//! Delaunay cells. The facets are collected when they are needed first.
class MeshAroundVertex
{
public:
    MeshAroundVertex(const RestrictedDelaunay& restricted, double reach)
        : restricted_(restricted), reach_(reach)
    {
    }

    //! Takes another vertex; `star`: its Delaunay cells, which must stay as they are while they are asked
    //! about.
    void assign(const Point3& site, const std::vector<DelaunayCell>& star)
    {
        site_ = site;
        star_ = &star;
        is_collected_ = false;
    }

    [[nodiscard]] bool explains(const Point3& crossing);

private:
    const RestrictedDelaunay& restricted_;
    double reach_;
    Point3 site_;
    const std::vector<DelaunayCell>* star_ = nullptr;
    bool is_collected_ = false;
    FacetCorners facets_;
};

//! Whether a point of the surface is nearer than `reach` to a facet that collect_close_facets() would keep,
//! and, where the oracle has an inventory, on the surface of such a facet. Looks at the facets around the
//! nearest vertex and at those in whose balls the point lies. Cost: O(log n) as a rule.
bool is_meshed(const RestrictedDelaunay& restricted, const Point3& p, double reach);

} // namespace voroprobe
