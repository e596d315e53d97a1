#include "mesher/restricted_delaunay.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "mesher/circumcenter.h"
#include "support/check.h"

namespace voroprobe
{
namespace
{

// Sentinels stand this many domain diagonals away along each axis. Any factor above 2 keeps their Voronoi
// cells out of the domain as soon as it holds one point; a little more keeps their Delaunay cells well
// shaped.
constexpr double kSentinelDistance = 8.0;

// Below this length it does not pay to clear the list of postponed cells.
constexpr std::size_t kLeastPostponedLimit = 1U << 16U;

// How many cells ahead query_even_facets() asks for the next ones.
constexpr std::size_t kPrefetchDistance = 4;

// Dual edges that one thread asks about in a row, and cells whose facets are asked about side by side.
constexpr std::size_t kQueriesAtOnce = 256;
constexpr std::size_t kCellsQueriedAtOnce = 1U << 11U;

bool has_unqueried_facet(DelaunayCell delaunay_cell)
{
    const auto& facets = delaunay_cell->info().facet;
    return std::find(facets.begin(), facets.end(), kUnqueriedFacet) != facets.end();
}

} // namespace

RestrictedDelaunay::RestrictedDelaunay(const SurfaceOracle& oracle, MeshingStatistics& statistics)
    : oracle_(oracle), statistics_(statistics)
{
    insert_sentinels();
}

// Four far points make the triangulation three-dimensional from the start and every dual edge that meets the
// domain bounded.
void RestrictedDelaunay::insert_sentinels()
{
    const Box3 domain = oracle_.domain();
    const Point3 center = domain.center();
    const double far = kSentinelDistance * domain.diagonal();
    for (const Vec3& direction : {Vec3{1, 1, 1}, Vec3{1, -1, -1}, Vec3{-1, 1, -1}, Vec3{-1, -1, 1}})
    {
        const VertexHandle vertex = triangulation_.insert(cgal_point(center + far * direction));
        vertex->info().index = vertex_index_bound_++;
        vertex->info().origin = VertexOrigin::kSentinel;
        vertex->info().cell_probed = true;
    }
    for (const DelaunayCell delaunay_cell : triangulation_.finite_cell_handles())
    {
        DelaunayCellData& data =
            delaunay_cell->info(); // without facets: their dual edges lie beyond the domain
        data.circumcenter = circumcenter(corner_positions(delaunay_cell));
        // Its region stays the outer one wherever that is: without a vertex there is no mesh.
    }
}

bool RestrictedDelaunay::is_apart(const Point3& p, double least_separation, VertexHandle hint) const
{
    const DelaunayCell near = hint == VertexHandle() ? DelaunayCell() : hint->cell();
    const VertexHandle nearest = triangulation_.nearest_vertex(cgal_point(p), near);
    return squared_distance(position(nearest), p) > least_separation * least_separation;
}

DelaunayCell RestrictedDelaunay::locate(const Point3& p, VertexHandle hint) const
{
    Triangulation::Locate_type type;
    int i = 0;
    int j = 0;
    const DelaunayCell near = hint == VertexHandle() ? DelaunayCell() : hint->cell();
    const DelaunayCell found = triangulation_.locate(cgal_point(p), type, i, j, near);
    return type == Triangulation::VERTEX ? DelaunayCell() : found;
}

VertexHandle RestrictedDelaunay::insert(const Point3& p, VertexOrigin origin, VertexHandle hint)
{
    workspace_.changed_facets.clear();
    const DelaunayCell start = locate(p, hint);
    if (start == DelaunayCell())
        return {};
    prepare(p, start, insertion_);
    return insert(insertion_, origin);
}

VertexHandle RestrictedDelaunay::insert(const Insertion& insertion, VertexOrigin origin)
{
    const VertexHandle vertex = insert(insertion, origin, workspace_);
    count(workspace_);
    forget_dead_postponed_cells();
    return vertex;
}

VertexHandle RestrictedDelaunay::insert(const Insertion& insertion, VertexOrigin origin,
                                        InsertionWorkspace& workspace)
{
    workspace.changed_facets.clear();
    ++workspace.insertions;
    workspace.queries += insertion.queries();
    workspace.region_lookups += insertion.star().size();
    forget_zone(insertion, workspace);
    check_persistence(insertion);
    const VertexHandle vertex = make_vertex(insertion, origin, workspace);
    delete_zone(insertion, workspace);
    make_star(insertion, vertex, workspace);
    connect_star(insertion, workspace);
    for (const Insertion::NewFacet& found : insertion.new_facets())
        add_facet(workspace.star[found.star_cell], found.facet, workspace);
    postpone_unqueried_facets(workspace);
    mark_unchecked(vertex, workspace);
    return vertex;
}

// Facets inside the zone vanish. Those on its boundary stay with the cell beyond, if their answers do.
void RestrictedDelaunay::forget_zone(const Insertion& insertion, InsertionWorkspace& workspace)
{
    const std::vector<ZoneFacet>& zone_facets = insertion.zone().facets();
    for (std::size_t f = 0; f < zone_facets.size(); ++f)
    {
        const ZoneFacet& zone_facet = zone_facets[f];
        FacetId& known = zone_facet.outer->info().facet[zone_facet.outer_index];
        const FacetId kept = insertion.star()[f].facet[zone_facet.inner_index];
        if (known < kUnqueriedFacet && kept == known)
        {
            facets_[known].delaunay_cell = zone_facet.outer;
            facets_[known].index = zone_facet.outer_index;
        }
        else if (known < kUnqueriedFacet)
            release_facet(known, workspace);
        known = kept;
        zone_facet.inner->info().facet[zone_facet.inner_index] = kNoFacet;
    }
    for (const DelaunayCell delaunay_cell : insertion.zone().cells())
    {
        for (const FacetId id : delaunay_cell->info().facet)
        {
            if (id < kUnqueriedFacet && facets_[id].crossing_count != 0) // met from its other cell already?
                release_facet(id, workspace);
        }
    }
}

// Lemma 1 of the report, in general: a point that keeps a distance from all vertices leaves the facets whose
// balls are smaller than half of it. A facet vanishes where its ball's center is nearer to the point than to
// its corners, so that these are nearer to the point than two radii. With a distance of at least the size
// criterion, as centers of balls that are too large and news of probing keep it, persistent facets stay.
void RestrictedDelaunay::check_persistence([[maybe_unused]] const Insertion& insertion) const
{
#if !defined(NDEBUG) || defined(VOROPROBE_CHECK_LEMMAS)
    constexpr double kRounding = 1e-6; // of squared lengths: of the circumcenters of slivers
    double squared_separation = std::numeric_limits<double>::infinity();
    for (const DelaunayCell delaunay_cell : insertion.zone().cells())
    {
        for (const Point3& corner : corner_positions(delaunay_cell))
            squared_separation = std::min(squared_separation, squared_distance(corner, insertion.point()));
    }
    for (const DelaunayCell delaunay_cell : insertion.zone().cells())
    {
        for (const FacetId id : delaunay_cell->info().facet) // those inside the zone, released just now
        {
            if (id < kUnqueriedFacet)
                CHECK_GE(4.0 * facets_[id].squared_radius, (1.0 - kRounding) * squared_separation);
        }
    }
#endif
}

VertexHandle RestrictedDelaunay::make_vertex(const Insertion& insertion, VertexOrigin origin,
                                             InsertionWorkspace& workspace)
{
    VertexHandle vertex;
    std::uint32_t index = 0;
    if (workspace.has_stock)
    {
        InsertionWorkspace::Stock& stock = workspace.stock;
        vertex = stock.vertices.back();
        stock.vertices.pop_back();
        index = stock.first_index + static_cast<std::uint32_t>(stock.new_vertices.size());
        stock.new_vertices.push_back(vertex);
    }
    else
    {
        vertex = triangulation_.tds().create_vertex();
        index = vertex_index_bound_++;
    }
    vertex->set_point(cgal_point(insertion.point()));
    VertexData& data = vertex->info();
    data.index = index;
    data.origin = origin;
    data.surface = insertion.surface();
    // The Voronoi cell of a new vertex is cut out of those of its neighbours: where all of them were probed,
    // so is it. Sentinels' cells lie beyond the domain as soon as there is another vertex.
    data.cell_probed = index > kSentinelCount && insertion.all_around_probed();
    if (!data.cell_probed)
        workspace.unprobed_vertices.push_back(vertex);
    return vertex;
}

// New cells take the places of the old ones in memory, which are warm.
void RestrictedDelaunay::delete_zone(const Insertion& insertion, InsertionWorkspace& workspace)
{
    for (const DelaunayCell delaunay_cell : insertion.zone().cells())
    {
        if (!workspace.has_stock)
            triangulation_.tds().delete_cell(delaunay_cell);
        else
        {
            delaunay_cell->info().facet.fill(kNoFacet); // nothing to ask about
            workspace.stock.cells.push_back(delaunay_cell);
        }
    }
}

DelaunayCell RestrictedDelaunay::make_cell(const std::array<VertexHandle, 4>& corners,
                                           InsertionWorkspace& workspace)
{
    if (!workspace.has_stock)
        return triangulation_.tds().create_cell(corners[0], corners[1], corners[2], corners[3]);
    const DelaunayCell made = workspace.stock.cells.back();
    workspace.stock.cells.pop_back();
    made->set_vertices(corners[0], corners[1], corners[2], corners[3]);
    return made;
}

void RestrictedDelaunay::make_star(const Insertion& insertion, VertexHandle vertex,
                                   InsertionWorkspace& workspace)
{
    workspace.star.clear();
    for (std::size_t f = 0; f < insertion.star().size(); ++f)
    {
        const ZoneFacet& zone_facet = insertion.zone().facets()[f];
        std::array<VertexHandle, 4> corners = zone_facet.corners;
        corners[zone_facet.inner_index] = vertex;
        const DelaunayCell made = make_cell(corners, workspace);
        for (const VertexHandle corner : corners)
        {
            if (workspace.has_stock && corner->info().origin == VertexOrigin::kSentinel)
                workspace.stock.cell_of_sentinel[corner->info().index] = made;
            else
                corner->set_cell(made);
        }
        const Insertion::StarCell& star_cell = insertion.star()[f];
        DelaunayCellData& data = made->info();
        data.circumcenter = star_cell.circumcenter;
        data.region = star_cell.region;
        data.facet = star_cell.facet;
        workspace.star.push_back(made);
    }
}

void RestrictedDelaunay::connect_star(const Insertion& insertion, const InsertionWorkspace& workspace)
{
    auto& tds = triangulation_.tds();
    const std::vector<DelaunayCell>& star = workspace.star;
    for (std::uint32_t f = 0; f < star.size(); ++f)
    {
        const ZoneFacet& zone_facet = insertion.zone().facets()[f];
        tds.set_adjacency(star[f], zone_facet.inner_index, zone_facet.outer, zone_facet.outer_index);
        for (std::uint8_t i = 0; i < 4; ++i)
        {
            const auto [g, index_of_g] = zone_facet.beyond[i];
            if (i != zone_facet.inner_index && f < g)
                tds.set_adjacency(star[f], i, star[g], index_of_g);
        }
    }
}

void RestrictedDelaunay::postpone_unqueried_facets(InsertionWorkspace& workspace)
{
    for (const DelaunayCell delaunay_cell : workspace.star)
    {
        if (has_unqueried_facet(delaunay_cell))
            workspace.postponed_cells.push_back(delaunay_cell);
    }
}

// Most cells noted are gone long before they would be asked about.
void RestrictedDelaunay::forget_dead_postponed_cells()
{
    std::vector<DelaunayCell>& postponed = workspace_.postponed_cells;
    if (postponed.size() < postponed_limit_)
        return;
    std::erase_if(postponed,
                  [&](DelaunayCell delaunay_cell) {
                      return !triangulation_.tds().cells().is_used(delaunay_cell) ||
                             !has_unqueried_facet(delaunay_cell);
                  });
    postponed_limit_ = std::max<std::size_t>(2 * postponed.size(), kLeastPostponedLimit);
}

// While the facets of some cells are asked about those of the next ones are gathered.
void RestrictedDelaunay::query_even_facets(const Workers& workers)
{
    workspace_.changed_facets.clear();
    std::span<const DelaunayCell> postponed = workspace_.postponed_cells;
    const auto take_next = [&]
    {
        const std::size_t count = std::min(postponed.size(), kCellsQueriedAtOnce);
        const auto next = postponed.first(count);
        postponed = postponed.subspan(count);
        return take_unqueried_facets(next);
    };
    std::vector<Unqueried> next = take_next();
    std::vector<RestrictedFacet> found;
    while (!next.empty() || !postponed.empty())
    {
        const std::vector<Unqueried> unqueried = std::exchange(next, {});
        found.assign(unqueried.size(), {});
        const auto query_batch = [&](std::size_t batch)
        {
            const std::size_t end = std::min((batch + 1) * kQueriesAtOnce, unqueried.size());
            for (std::size_t i = batch * kQueriesAtOnce; i < end; ++i)
                query(unqueried[i], found[i]);
        };
        const std::size_t batches = (unqueried.size() + kQueriesAtOnce - 1) / kQueriesAtOnce;
        workers.for_each(
            1 + batches, [&](std::size_t i) { i == 0 ? void(next = take_next()) : query_batch(i - 1); }, 1);
        statistics_.queries_refinement += unqueried.size();
        for (std::size_t i = 0; i < unqueried.size(); ++i)
        {
            if (found[i].crossing_count != 0)
                add_facet(unqueried[i].delaunay_cell, found[i], workspace_);
        }
    }
    workspace_.postponed_cells = std::vector<DelaunayCell>(); // never as long again as it was at first
}

// Until the oracle has answered, the facets count as not crossed.
std::vector<RestrictedDelaunay::Unqueried>
RestrictedDelaunay::take_unqueried_facets(std::span<const DelaunayCell> delaunay_cells)
{
    std::vector<Unqueried> facets;
    const auto is_used = [&](DelaunayCell delaunay_cell)
    {
        return triangulation_.tds().cells().is_used(
            delaunay_cell); // a new cell in an old one's place is as welcome
    };
    for (std::size_t c = 0; c < delaunay_cells.size(); ++c)
    {
        // Half of the time here would be spent on waiting for the cells beyond the facets.
        if (c + kPrefetchDistance < delaunay_cells.size() && is_used(delaunay_cells[c + kPrefetchDistance]))
        {
            for (int i = 0; i < 4; ++i)
                prefetch(delaunay_cells[c + kPrefetchDistance]->neighbor(i));
        }
        const DelaunayCell delaunay_cell = delaunay_cells[c];
        if (!is_used(delaunay_cell))
            continue;
        for (std::uint8_t i = 0; i < 4; ++i)
        {
            if (delaunay_cell->info().facet[i] != kUnqueriedFacet)
                continue;
            facets.push_back({delaunay_cell, i});
            const DelaunayCell next = delaunay_cell->neighbor(i);
            delaunay_cell->info().facet[i] = kNoFacet;
            next->info().facet[static_cast<std::size_t>(next->index(delaunay_cell))] = kNoFacet;
        }
    }
    return facets;
}

void RestrictedDelaunay::query(const Unqueried& unqueried, RestrictedFacet& facet) const
{
    thread_local std::vector<Crossing> crossings;
    const auto [delaunay_cell, index] = unqueried;
    const DelaunayCell next = delaunay_cell->neighbor(index);
    if (triangulation_.is_infinite(delaunay_cell) || triangulation_.is_infinite(next))
        return;
    oracle_.find_crossings({delaunay_cell->info().circumcenter, next->info().circumcenter}, crossings);
    facet.index = index;
    set_crossings(facet, crossings, position(delaunay_cell->vertex((index + 1) & 3)));
}

// Keeps what is known of a facet on both of its sides.
void RestrictedDelaunay::add_facet(DelaunayCell delaunay_cell, RestrictedFacet facet,
                                   InsertionWorkspace& workspace)
{
    const int index = facet.index;
    const DelaunayCell next = delaunay_cell->neighbor(index);
    const FacetId id = allocate_facet(workspace);
    delaunay_cell->info().facet[static_cast<std::size_t>(index)] = id;
    next->info().facet[static_cast<std::size_t>(mirror_index(delaunay_cell, index, next))] = id;
    facet.delaunay_cell = delaunay_cell;
    for (std::size_t k = 0; k < 3; ++k)
        facet.vertices[k] = delaunay_cell->vertex((index + static_cast<int>(k) + 1) & 3)->info().index;
    facet.generation = facets_[id].generation;
    facets_[id] = facet;
    mark_unchecked(facet, workspace);
    workspace.changed_facets.push_back(id);
}

void RestrictedDelaunay::mark_unchecked(const RestrictedFacet& facet, InsertionWorkspace& workspace)
{
    if (!facet.odd())
        return;
    for (int i = 0; i < 4; ++i)
    {
        if (i != facet.index)
            mark_unchecked(facet.delaunay_cell->vertex(i), workspace);
    }
}

void RestrictedDelaunay::mark_unchecked(VertexHandle vertex, InsertionWorkspace& workspace)
{
    VertexData& data = vertex->info();
    if (data.umbrella_unchecked || data.origin == VertexOrigin::kSentinel)
        return;
    data.umbrella_unchecked = true;
    data.pinched = true; // until looked at again
    workspace.unchecked_vertices.push_back(vertex);
}

std::vector<VertexHandle> RestrictedDelaunay::take_unchecked_vertices()
{
    for (const VertexHandle vertex : workspace_.unchecked_vertices)
        vertex->info().umbrella_unchecked = false;
    return std::exchange(workspace_.unchecked_vertices, {});
}

void RestrictedDelaunay::odd_facets_around(VertexHandle vertex, std::vector<FacetId>& facets)
{
    facets.clear();
    cells_around_.clear();
    triangulation_.incident_cells(vertex, std::back_inserter(cells_around_));
    for (const DelaunayCell delaunay_cell : cells_around_)
    {
        for (int i = 0; i < 4; ++i)
        {
            const FacetId id = delaunay_cell->info().facet[static_cast<std::size_t>(i)];
            if (id >= kUnqueriedFacet || delaunay_cell->vertex(i) == vertex)
                continue;
            const RestrictedFacet& facet = facets_[id]; // seen from both of its cells, taken from one
            if (facet.odd() && facet.delaunay_cell == delaunay_cell && facet.index == i)
                facets.push_back(id);
        }
    }
}

std::size_t RestrictedDelaunay::count_unresolved_facets() const
{
    return static_cast<std::size_t>(std::count_if(facets_.begin(), facets_.end(),
                                                  [](const RestrictedFacet& facet)
                                                  { return facet.crossing_count > 1; }));
}

DelaunayCell RestrictedDelaunay::conflicting_cell(const RestrictedFacet& facet) const
{
    const auto center = cgal_point(facet.center);
    for (const DelaunayCell side : {facet.delaunay_cell, facet.delaunay_cell->neighbor(facet.index)})
    {
        if (triangulation_.side_of_sphere(side, center) == CGAL::ON_BOUNDED_SIDE)
            return side;
    }
    return {};
}

SurfaceId RestrictedDelaunay::surface(const RestrictedFacet& facet) const
{
    return oracle_.surface_between(facet.delaunay_cell->info().region,
                                   facet.delaunay_cell->neighbor(facet.index)->info().region);
}

bool RestrictedDelaunay::is_faithful(const RestrictedFacet& facet) const
{
    const SurfaceId separating = surface(facet);
    if (separating == kNoSurface)
        return false;
    for (int i = 0; i < 4; ++i)
    {
        if (i != facet.index && facet.delaunay_cell->vertex(i)->info().surface != separating)
            return false;
    }
    return true;
}

std::array<Point3, 3> RestrictedDelaunay::corners(const RestrictedFacet& facet) const
{
    const int i = facet.index;
    return {position(facet.delaunay_cell->vertex((i + 1) & 3)),
            position(facet.delaunay_cell->vertex((i + 2) & 3)),
            position(facet.delaunay_cell->vertex((i + 3) & 3))};
}

FacetId RestrictedDelaunay::allocate_facet(InsertionWorkspace& workspace)
{
    if (workspace.free_facets.empty())
    {
        CHECK(!workspace.has_stock);
        CHECK_LT(facets_.size(), static_cast<std::size_t>(kUnqueriedFacet));
        facets_.emplace_back();
        return static_cast<FacetId>(facets_.size() - 1);
    }
    const FacetId id = workspace.free_facets.back();
    workspace.free_facets.pop_back();
    if (workspace.has_stock)
        workspace.stock.new_facets.push_back(id);
    return id;
}

void RestrictedDelaunay::release_facet(FacetId id, InsertionWorkspace& workspace)
{
    RestrictedFacet& facet = facets_[id];
    mark_unchecked(facet, workspace);
    facet.crossing_count = 0;
    ++facet.generation;
    workspace.free_facets.push_back(id);
}

void RestrictedDelaunay::count(InsertionWorkspace& workspace)
{
    statistics_.insertions += std::exchange(workspace.insertions, 0);
    statistics_.queries_refinement += std::exchange(workspace.queries, 0);
    statistics_.region_lookups += std::exchange(workspace.region_lookups, 0);
}

} // namespace voroprobe
