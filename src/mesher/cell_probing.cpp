#include "mesher/cell_probing.h"

#include <algorithm>
#include <iterator>

#include <CGAL/iterator.h>

#include "mesher/cell_prober.h"

namespace voroprobe
{
namespace
{

// Cells probed side by side between looks for whether to stop, and those of them that one thread has in a
// row.
constexpr std::size_t kCellsBetweenLooks = 16384;
constexpr std::size_t kCellsInARow = 256;

ProbedDomain probed_domain(const SurfaceOracle& oracle, const MeshingOptions& options)
{
    if (!options.domain_ball)
        return {oracle.domain(), std::nullopt};
    const Point3& center = options.domain_ball->center;
    return {Box3{center, center}.expanded(options.domain_ball->radius), options.domain_ball};
}

} // namespace

CellProbing::CellProbing(RestrictedDelaunay& restricted, const MeshingOptions& options,
                         const Workers& workers, MeshingStatistics& statistics, const ProgressSink& stop)
    : restricted_(restricted), options_(options), workers_(workers), statistics_(statistics),
      domain_(probed_domain(restricted.oracle(), options)),
      probe_radius_(options.component_radius.value_or(options.reach_lower_bound)),
      probing_(restricted.oracle(), probe_radius_, counts_, stop), slab_probing_(probing_),
      mesh_(restricted, options.reach_lower_bound),
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
    collect_unprobed_cells();
    const auto size_now = [&](VertexHandle vertex)
    {
        voronoi_cell_.assign(vertex);
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

// The cells of the vertices inserted since the last time. Those that few probes are enough for, without a hit
// that the mesh around the vertex does not explain, are probed at once: when that is done changes nothing,
// they take no turns, and threads can do it side by side.
void CellProbing::collect_unprobed_cells()
{
    const std::vector<VertexHandle> vertices = restricted_.take_unprobed_vertices();
    for (std::size_t begin = 0; begin < vertices.size() && !probing_.stop_requested();
         begin += kCellsBetweenLooks)
        probe_by_few(vertices, begin, std::min(begin + kCellsBetweenLooks, vertices.size()));
    update_statistics();
}

void CellProbing::probe_by_few(const std::vector<VertexHandle>& vertices, std::size_t begin, std::size_t end)
{
    std::vector<std::optional<double>> size_unless_probed(end - begin);
    const std::size_t rows = (end - begin + kCellsInARow - 1) / kCellsInARow;
    std::vector<ProbeCounts> counts(rows);
    const auto probe_row = [&](std::size_t row)
    {
        CellProber prober(restricted_, domain_, probe_radius_, options_.reach_lower_bound);
        for (std::size_t c = row * kCellsInARow; c < std::min((row + 1) * kCellsInARow, end - begin); ++c)
        {
            const VertexHandle vertex = vertices[begin + c];
            const bool is_probed = options_.certified_skipping ? prober.probe_by_few(vertex)
                                                               : prober.is_probed_by_its_edges(vertex);
            if (!is_probed)
                size_unless_probed[c] = prober.size();
        }
        counts[row] = prober.counts();
    };
    workers_.for_each(rows, probe_row, 1);
    for (std::size_t c = 0; c < size_unless_probed.size(); ++c)
    {
        const VertexHandle vertex = vertices[begin + c];
        if (size_unless_probed[c])
            unprobed_cells_.push(vertex, *size_unless_probed[c]);
        else
        {
            ++statistics_.cells_probed_at_once;
            vertex->info().cell_probed = true;
        }
    }
    for (const ProbeCounts& of_row : counts)
        counts_ += of_row;
}

std::optional<Point3> CellProbing::probe_cell(VertexHandle vertex)
{
    ++statistics_.cells_probed;
    voronoi_cell_.assign(vertex);
    mesh_.assign(voronoi_cell_.site(), voronoi_cell_.star());
    std::optional<Point3> hit;
    if (options_.certified_skipping)
    {
        voronoi_cell_.clipped_outline(domain_, outline_);
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
    if (mesh_.explains(crossing))
        return false;

    const auto& triangulation = restricted_.triangulation();
    const auto p = cgal_point(crossing);
    const DelaunayCell start = triangulation.locate(p, voronoi_cell_.vertex()->cell());
    const double squared_reach = options_.reach_lower_bound * options_.reach_lower_bound;
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
