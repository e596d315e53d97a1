#include "mesher/nearby_facets.h"

#include <algorithm>
#include <iterator>

#include <CGAL/iterator.h>

#include "geometry/point_triangle.h"

namespace voroprobe
{
namespace
{

bool is_close(const RestrictedDelaunay& restricted, FacetId id, double reach)
{
    if (id >= kUnqueriedFacet || !restricted.facet(id).odd())
        return false;
    const RestrictedFacet& facet = restricted.facet(id);
    return facet.squared_radius - squared_circumradius(restricted.corners(facet)) <= reach * reach;
}

} // namespace

void collect_close_facets(const RestrictedDelaunay& restricted,
                          const std::vector<DelaunayCell>& delaunay_cells, double reach, FacetCorners& facets)
{
    facets.clear();
    for (const DelaunayCell delaunay_cell : delaunay_cells)
    {
        for (const FacetId id : delaunay_cell->info().facet)
        {
            if (is_close(restricted, id, reach))
                facets.push_back(restricted.corners(restricted.facet(id)));
        }
    }
}

bool is_near(const FacetCorners& facets, const Point3& p, double reach)
{
    return std::any_of(facets.begin(), facets.end(),
                       [&](const std::array<Point3, 3>& corners)
                       { return squared_distance_to_triangle(p, corners) < reach * reach; });
}

bool MeshAroundVertex::explains(const Point3& crossing)
{
    if (squared_distance(crossing, site_) < reach_ * reach_)
        return true;
    if (!is_collected_)
        collect_close_facets(restricted_, *star_, reach_, facets_);
    is_collected_ = true;
    return is_near(facets_, crossing, reach_);
}

bool is_meshed(const RestrictedDelaunay& restricted, const Point3& p, double reach)
{
    const auto& triangulation = restricted.triangulation();
    const DelaunayCell place = triangulation.locate(cgal_point(p));
    std::vector<DelaunayCell> around;
    triangulation.find_conflicts(cgal_point(p), place, CGAL::Emptyset_iterator(), std::back_inserter(around));
    triangulation.incident_cells(triangulation.nearest_vertex(cgal_point(p), place),
                                 std::back_inserter(around));
    const SurfaceId surface = restricted.oracle().surface_at(p);
    for (const DelaunayCell delaunay_cell : around)
    {
        for (const FacetId id : delaunay_cell->info().facet)
        {
            if (is_close(restricted, id, reach) &&
                (surface == kNoSurface || restricted.surface(restricted.facet(id)) == surface) &&
                squared_distance_to_triangle(p, restricted.corners(restricted.facet(id))) < reach * reach)
                return true;
        }
    }
    return false;
}

} // namespace voroprobe
