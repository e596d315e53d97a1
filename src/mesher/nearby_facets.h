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

//! Whether a point of the surface is nearer than `reach` to a facet that collect_close_facets() would keep,
//! and, where the oracle has an inventory, on the surface of such a facet. Looks at the facets around the
//! nearest vertex and at those in whose balls the point lies. Cost: O(log n) as a rule.
bool is_meshed(const RestrictedDelaunay& restricted, const Point3& p, double reach);

} // namespace voroprobe
