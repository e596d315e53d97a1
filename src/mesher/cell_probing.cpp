#include "mesher/cell_probing.h"

#include <algorithm>
#include <iterator>

#include <CGAL/iterator.h>

namespace voroprobe
{
namespace
{

constexpr std::size_t kCellsBetweenLooks = 1024; // for whether to stop

ProbedDomain probed_domain(const SurfaceOracle& oracle, const MeshingOptions& options)
{
    if (!options.domain_ball)
        return {oracle.domain(), std::nullopt};
    const Point3& center = options.domain_ball->center;
    return {Box3{center, center}.expanded(options.domain_ball->radius), options.domain_ball};
}

} // namespace

CellProbing::CellProbing(RestrictedDelaunay& restricted, const MeshingOptions& options,
                         MeshingStatistics& statistics, const ProgressSink& stop)
    : restricted_(restricted), options_(options), statistics_(statistics),
      domain_(probed_domain(restricted.oracle(), options)),
      probe_radius_(options.component_radius.value_or(options.reach_lower_bound)),
      probing_(restricted.oracle(), probe_radius_, counts_, stop), slab_probing_(probing_),
      is_news_([this](const Point3& crossing) { return is_news(crossing); })
{
}

std::optional<ProbeHit> CellProbing::probe_domain()
{
    const IsNews is_news = [](const Point3&) { return true; };
    std::optional<Point3> hit;
    if (options_.certified_skipping)
    {
        outline_ = domain_outline(domain_);
        hit = probe_slabs(is_news);
    }
    else
    {
        make_domain_region(domain_, region_);
        hit = probing_.probe_all(region_, is_news);
    }
    update_statistics();
    return hit ? std::optional(ProbeHit{*hit, {}}) : std::nullopt;
}

std::optional<Point3> CellProbing::probe_slabs(const IsNews& is_news)
{
    const auto outcome = slab_probing_.probe(outline_, is_news, SlabProbing::Effort::kAllProbes);
    return outcome == SlabProbing::Outcome::kNews ? std::optional(slab_probing_.news()) : std::nullopt;
}

void CellProbing::update_statistics()
{
    statistics_.queries_probing = counts_.queries;
    statistics_.probe_hits_passed_over = counts_.hits_passed_over;
}

std::optional<ProbeHit> CellProbing::probe_cells_until_hit()
{
    facets_of_ = {}; // the mesh has changed since
    collect_unprobed_cells();
    const auto size_now = [&](VertexHandle vertex)
    {
        voronoi_cell_.assign(restricted_, vertex);
        return voronoi_cell_.size_within(domain_.box);
    };
    while (!unprobed_cells_.empty() && !probing_.stop_requested())
    {
        const VertexHandle vertex = unprobed_cells_.pop(size_now);
        if (const auto hit = probe_cell(vertex))
        {
            unprobed_cells_.push(vertex, size_now(vertex)); // the rest of it
            ++statistics_.probe_hits;
            return ProbeHit{*hit, vertex};
        }
        vertex->info().cell_probed = !probing_.was_stopped();
    }
    return std::nullopt;
}

// The cells of the vertices inserted since the last time. Those that can be probed at once, and without a
// hit, are: when that is done changes nothing, and here they are warm in the cache.
void CellProbing::collect_unprobed_cells()
{
    std::size_t count = 0;
    for (const VertexHandle vertex : restricted_.take_unprobed_vertices())
    {
        voronoi_cell_.assign(restricted_, vertex);
        const bool is_probed =
            options_.certified_skipping ? probe_with_few_probes() : is_probed_by_its_edges();
        if (probing_.was_stopped() || (++count % kCellsBetweenLooks == 0 && probing_.stop_requested()))
            return;
        if (is_probed)
        {
            ++statistics_.cells_probed_at_once;
            vertex->info().cell_probed = true;
        }
        else
            unprobed_cells_.push(vertex, voronoi_cell_.size_within(domain_.box));
    }
    update_statistics();
}

bool CellProbing::probe_with_few_probes()
{
    voronoi_cell_.outline(domain_, outline_);
    return slab_probing_.probe(outline_, is_news_, SlabProbing::Effort::kFewProbes) ==
           SlabProbing::Outcome::kProbed;
}

// Whether every point of the cell is near one of its edges: refinement has asked about all Voronoi edges. See
// SlabProbing for the proof.
bool CellProbing::is_probed_by_its_edges() const
{
    return voronoi_cell_.is_within(domain_) && voronoi_cell_.cylinder().radius <= probe_radius_;
}

std::optional<Point3> CellProbing::probe_cell(VertexHandle vertex)
{
    ++statistics_.cells_probed;
    voronoi_cell_.assign(restricted_, vertex);
    std::optional<Point3> hit;
    if (options_.certified_skipping)
    {
        voronoi_cell_.outline(domain_, outline_);
        hit = probe_slabs(is_news_);
    }
    else
    {
        voronoi_cell_.clip_to(domain_, region_);
        if (!region_.corners.empty()) // otherwise it misses the domain
            hit = probing_.probe_all(region_, is_news_);
    }
    update_statistics();
    return hit;
}

// A facet near the crossing is nearly always in the star of the nearest vertex. Where it is not, a new vertex
// at the crossing would be inside one of its balls: it is in the conflict zone.
bool CellProbing::is_news(const Point3& crossing)
{
    if (facets_of_ != voronoi_cell_.vertex())
    {
        facets_of_ = voronoi_cell_.vertex();
        collect_close_facets(restricted_, voronoi_cell_.star(), options_.reach_lower_bound, facets_near_);
    }
    const double squared_reach = options_.reach_lower_bound * options_.reach_lower_bound;
    if (squared_distance(crossing, voronoi_cell_.site()) < squared_reach ||
        is_near(facets_near_, crossing, options_.reach_lower_bound))
        return false;

    const auto& triangulation = restricted_.triangulation();
    const auto p = cgal_point(crossing);
    const DelaunayCell start = triangulation.locate(p, voronoi_cell_.vertex()->cell());
    zone_.clear();
    triangulation.find_conflicts(p, start, CGAL::Emptyset_iterator(), std::back_inserter(zone_));
    for (const DelaunayCell delaunay_cell : zone_)
    {
        for (const Point3& corner : corner_positions(delaunay_cell))
        {
            if (squared_distance(corner, crossing) < squared_reach)
                return false;
        }
    }
    collect_close_facets(restricted_, zone_, options_.reach_lower_bound, facets_in_zone_);
    return !zone_.empty() && !is_near(facets_in_zone_, crossing, options_.reach_lower_bound);
}

} // namespace voroprobe
