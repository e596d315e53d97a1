#include "mesher/cell_probing.h"

#include <algorithm>
#include <iterator>
#include <numbers>

#include <CGAL/iterator.h>

#include "mesher/point_triangle.h"

namespace voroprobe
{
namespace
{

ProbedDomain probed_domain(const SurfaceOracle& oracle, const MeshingOptions& options)
{
    if (!options.domain_ball)
        return {oracle.domain(), std::nullopt};
    const Point3& center = options.domain_ball->center;
    return {Box3{center, center}.expanded(options.domain_ball->radius), options.domain_ball};
}

} // namespace

CellProbing::CellProbing(RestrictedDelaunay& restricted, const MeshingOptions& options,
                         MeshingStatistics& statistics)
    : restricted_(restricted), options_(options), statistics_(statistics),
      domain_(probed_domain(restricted.oracle(), options)),
      probe_radius_(options.component_radius.value_or(options.reach_lower_bound)),
      probing_(restricted.oracle(), probe_radius_, counts_)
{
}

std::optional<ProbeHit> CellProbing::probe_domain()
{
    make_domain_region(domain_, region_);
    const auto hit = probe(region_, [](const Point3&) { return true; });
    return hit ? std::optional(ProbeHit{*hit, {}}) : std::nullopt;
}

std::optional<Point3> CellProbing::probe(const ConvexRegion& region, const IsNews& is_news)
{
    const auto news = options_.certified_skipping ? probing_.probe_uncertified(region, is_news)
                                                  : probing_.probe_all(region, is_news);
    statistics_.queries_probing = counts_.queries;
    statistics_.probe_hits_passed_over = counts_.hits_passed_over;
    return news;
}

std::optional<ProbeHit> CellProbing::probe_cells_until_hit(const std::function<bool()>& stop)
{
    collect_unprobed_cells();
    const auto size_now = [&](VertexHandle vertex)
    {
        voronoi_cell_.assign(restricted_, vertex);
        return voronoi_cell_.size_within(domain_.box);
    };
    while (!unprobed_cells_.empty() && !stop())
    {
        const VertexHandle vertex = unprobed_cells_.pop(size_now);
        if (const auto hit = probe_cell(vertex))
        {
            unprobed_cells_.push(vertex, size_now(vertex)); // the rest of it
            ++statistics_.probe_hits;
            return ProbeHit{*hit, vertex};
        }
        vertex->info().cell_probed = true;
    }
    return std::nullopt;
}

// The cells of the vertices inserted since the last time. Those that need no probe, for every point of them
// is near a Voronoi edge, are probed as they stand: refinement has asked about all Voronoi edges.
void CellProbing::collect_unprobed_cells()
{
    for (const VertexHandle vertex : restricted_.take_unprobed_vertices())
    {
        voronoi_cell_.assign(restricted_, vertex);
        if (probe_at_once())
            vertex->info().cell_probed = true;
        else
            unprobed_cells_.push(vertex, voronoi_cell_.size_within(domain_.box));
    }
}

// Whether the cell at hand could be probed without a hit, where that takes no more than two queries.
bool CellProbing::probe_at_once()
{
    if (!voronoi_cell_.is_within(domain_))
        return false;
    const Cylinder cylinder = voronoi_cell_.cylinder();
    if (cylinder.radius <= probe_radius_)
    {
        ++statistics_.cells_without_probes;
        return true;
    }
    if (cylinder.radius > std::numbers::sqrt2 * probe_radius_)
        return false;
    ++statistics_.cells_with_one_probe;
    const Point3& end = cylinder.axis.source;
    const Point3& corner = *std::min_element(voronoi_cell_.corners().begin(), voronoi_cell_.corners().end(),
                                             [&](const Point3& a, const Point3& b)
                                             { return squared_distance(a, end) < squared_distance(b, end); });
    const IsNews news = [this](const Point3& crossing) { return is_news(crossing); };
    return !probing_.query(cylinder.axis, news) && !probing_.query({end, corner}, news);
}

std::optional<Point3> CellProbing::probe_cell(VertexHandle vertex)
{
    ++statistics_.cells_probed;
    voronoi_cell_.assign(restricted_, vertex);
    voronoi_cell_.clip_to(domain_, region_);
    if (region_.corners.empty())
        return std::nullopt; // it misses the domain
    return probe(region_, [this](const Point3& crossing) { return is_news(crossing); });
}

// A facet near the crossing is nearly always in the star of the nearest vertex. Where it is not, a new vertex
// at the crossing would be inside one of its balls: it is in the conflict zone.
bool CellProbing::is_news(const Point3& crossing)
{
    if (is_explained(crossing, voronoi_cell_.star()))
        return false;
    const auto& triangulation = restricted_.triangulation();
    const auto p = cgal_point(crossing);
    const DelaunayCell start = triangulation.locate(p, voronoi_cell_.vertex()->cell());
    std::vector<DelaunayCell> zone;
    triangulation.find_conflicts(p, start, CGAL::Emptyset_iterator(), std::back_inserter(zone));
    return !zone.empty() && !is_explained(crossing, zone);
}

// Whether the crossing is nearer than the reach to the odd facets of the Delaunay cells, or to their
// vertices.
bool CellProbing::is_explained(const Point3& crossing, const std::vector<DelaunayCell>& delaunay_cells)
{
    const double squared_reach = options_.reach_lower_bound * options_.reach_lower_bound;
    for (const DelaunayCell delaunay_cell : delaunay_cells)
    {
        for (int i = 0; i < 4; ++i)
        {
            if (squared_distance(position(delaunay_cell->vertex(i)), crossing) < squared_reach)
                return true;
            const FacetId id = delaunay_cell->info().facet[static_cast<std::size_t>(i)];
            if (id >= kUnqueriedFacet || !restricted_.facet(id).odd())
                continue;
            const RestrictedFacet& facet = restricted_.facet(id);
            const auto corners = restricted_.corners(facet);
            if (facet.squared_radius - squared_circumradius(corners) <= squared_reach &&
                squared_distance_to_triangle(crossing, corners) < squared_reach)
                return true;
        }
    }
    return false;
}

} // namespace voroprobe
