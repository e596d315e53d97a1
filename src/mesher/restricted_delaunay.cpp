#include "mesher/restricted_delaunay.h"

#include <algorithm>
#include <iterator>
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

void prefetch(DelaunayCell delaunay_cell)
{
    constexpr std::size_t kCacheLineBytes = 64;
    const char* begin = reinterpret_cast<const char*>(&*delaunay_cell);
    for (std::size_t offset = 0; offset < sizeof(*delaunay_cell); offset += kCacheLineBytes)
        __builtin_prefetch(begin + offset);
}

std::uint8_t capped_count(std::size_t count)
{
    return static_cast<std::uint8_t>(count <= 255 ? count : 254 + (count & 1U));
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
        vertex->info().index = static_cast<std::uint32_t>(triangulation_.number_of_vertices() - 1);
        vertex->info().origin = VertexOrigin::kSentinel;
        vertex->info().cell_probed = true;
    }
    for (const DelaunayCell delaunay_cell : triangulation_.finite_cell_handles())
    {
        set_dual_vertex(delaunay_cell);
        delaunay_cell->info().facet.fill(kNoFacet); // their dual edges lie beyond the domain
    }
}

bool RestrictedDelaunay::is_apart(const Point3& p, double least_separation, VertexHandle hint) const
{
    const VertexHandle nearest = triangulation_.nearest_vertex(cgal_point(p), hint->cell());
    return squared_distance(position(nearest), p) > least_separation * least_separation;
}

VertexHandle RestrictedDelaunay::insert(const Point3& p, VertexOrigin origin, VertexHandle hint)
{
    changed_facets_.clear();
    Triangulation::Locate_type type;
    int i = 0;
    int j = 0;
    const DelaunayCell near = hint == VertexHandle() ? DelaunayCell() : hint->cell();
    const DelaunayCell start = triangulation_.locate(cgal_point(p), type, i, j, near);
    return type == Triangulation::VERTEX ? VertexHandle() : insert(p, start, origin);
}

VertexHandle RestrictedDelaunay::insert(const Point3& p, DelaunayCell start, VertexOrigin origin)
{
    changed_facets_.clear();
    zone_cells_.clear();
    zone_boundary_.clear();
    triangulation_.find_conflicts(cgal_point(p), start, std::back_inserter(zone_boundary_),
                                  std::back_inserter(zone_cells_));
    forget_zone();
    const auto& [begin_cell, begin_index] = zone_boundary_.front();
    const VertexHandle vertex = triangulation_.insert_in_hole(cgal_point(p), zone_cells_.begin(),
                                                              zone_cells_.end(), begin_cell, begin_index);
    vertex->info().index = static_cast<std::uint32_t>(triangulation_.number_of_vertices() - 1);
    vertex->info().origin = origin;
    vertex->info().surface = oracle_.surface_at(p);
    ++statistics_.insertions;

    // Every boundary facet of the zone now has one new cell on its inner side.
    star_.clear();
    for (const ZoneBoundaryFacet& boundary : boundary_)
    {
        star_.push_back(boundary.outer->neighbor(boundary.outer_index));
        set_dual_vertex(star_.back());
    }
    for (const ZoneBoundaryFacet& boundary : boundary_)
        carry_over(boundary, p);
    for (const DelaunayCell delaunay_cell : star_)
    {
        const auto& facets = delaunay_cell->info().facet;
        for (int i = 0; i < 4; ++i)
        {
            if (facets[static_cast<std::size_t>(i)] == kUnqueriedFacet)
                query_or_postpone(delaunay_cell, i);
        }
        if (std::find(facets.begin(), facets.end(), kUnqueriedFacet) != facets.end())
            postponed_cells_.push_back(delaunay_cell);
    }
    forget_dead_postponed_cells();
    note_unprobed(vertex);
    mark_unchecked(vertex);
    return vertex;
}

// The Voronoi cell of a new vertex is cut out of those of its neighbours: where all of them were probed, so
// is it. Sentinels' cells lie beyond the domain as soon as there is another vertex.
void RestrictedDelaunay::note_unprobed(VertexHandle vertex)
{
    if (vertex_count() == 1)
    {
        unprobed_vertices_.push_back(vertex);
        return;
    }
    const auto is_probed = [&](VertexHandle other) { return other == vertex || other->info().cell_probed; };
    for (const DelaunayCell delaunay_cell : star_)
    {
        for (int i = 0; i < 4; ++i)
        {
            if (!is_probed(delaunay_cell->vertex(i)))
            {
                unprobed_vertices_.push_back(vertex);
                return;
            }
        }
    }
    vertex->info().cell_probed = true;
}

// Before the zone is retriangulated: facets inside it vanish, those on its boundary are remembered from the
// outer side.
void RestrictedDelaunay::forget_zone()
{
    boundary_.clear();
    for (const auto& [delaunay_cell, index] : zone_boundary_)
    {
        FacetId& slot = delaunay_cell->info().facet[static_cast<std::size_t>(index)];
        const ZoneBoundaryFacet boundary{delaunay_cell->neighbor(index),
                                         triangulation_.mirror_index(delaunay_cell, index), slot};
        slot = kNoFacet; // what stays in the slots lies inside the zone
        if (boundary.facet < kUnqueriedFacet)
        {
            facets_[boundary.facet].delaunay_cell = boundary.outer;
            facets_[boundary.facet].index = static_cast<std::uint8_t>(boundary.outer_index);
        }
        boundary_.push_back(boundary);
    }
    for (const DelaunayCell delaunay_cell : zone_cells_)
    {
        for (const FacetId id : delaunay_cell->info().facet)
        {
            if (id < kUnqueriedFacet && facets_[id].crossing_count != 0) // met from its other cell already?
                release_facet(id);
        }
    }
}

void RestrictedDelaunay::set_dual_vertex(DelaunayCell delaunay_cell)
{
    DelaunayCellData& data = delaunay_cell->info();
    data = DelaunayCellData{};
    data.facet.fill(kUnqueriedFacet);
    if (triangulation_.is_infinite(delaunay_cell))
        return;
    data.circumcenter = circumcenter(corner_positions(delaunay_cell));
    data.region = oracle_.region(data.circumcenter);
    ++statistics_.region_lookups;
}

// A facet on the boundary of the zone keeps what was known of it where that still holds.
void RestrictedDelaunay::carry_over(const ZoneBoundaryFacet& boundary, const Point3& inserted)
{
    const DelaunayCell inner = boundary.outer->neighbor(boundary.outer_index);
    const int inner_index = triangulation_.mirror_index(boundary.outer, boundary.outer_index);
    FacetId& inner_facet = inner->info().facet[static_cast<std::size_t>(inner_index)];
    const bool odd = separates_sides(boundary.outer, boundary.outer_index);
    if (boundary.facet == kUnqueriedFacet)
    {
        query_or_postpone(boundary.outer, boundary.outer_index);
        return;
    }
    if (boundary.facet == kNoFacet && !odd)
    {
        inner_facet = kNoFacet;
        return;
    }
    if (boundary.facet != kNoFacet && facets_[boundary.facet].crossing_count == 1)
    {
        const RestrictedFacet& known = facets_[boundary.facet];
        const bool center_stays = squared_distance(known.center, inserted) >= known.squared_radius;
        if (odd && center_stays)
        {
            inner_facet = boundary.facet;
            return;
        }
        if (!odd && !center_stays)
        {
            release_facet(boundary.facet);
            boundary.outer->info().facet[static_cast<std::size_t>(boundary.outer_index)] = kNoFacet;
            inner_facet = kNoFacet;
            return;
        }
    }
    // One of several crossings may have gone, or rounding moved a Voronoi vertex across the surface.
    query_dual_edge(boundary.outer, boundary.outer_index, boundary.facet);
}

void RestrictedDelaunay::query_or_postpone(DelaunayCell delaunay_cell, int index)
{
    if (separates_sides(delaunay_cell, index))
        query_dual_edge(delaunay_cell, index, kNoFacet);
}

// Most cells noted are gone long before they would be asked about.
void RestrictedDelaunay::forget_dead_postponed_cells()
{
    if (postponed_cells_.size() < postponed_limit_)
        return;
    std::erase_if(postponed_cells_, [&](DelaunayCell delaunay_cell)
                  { return !triangulation_.tds().cells().is_used(delaunay_cell); });
    postponed_limit_ = std::max<std::size_t>(2 * postponed_cells_.size(), kLeastPostponedLimit);
}

void RestrictedDelaunay::query_even_facets()
{
    changed_facets_.clear();
    const auto is_used = [&](DelaunayCell delaunay_cell)
    {
        return triangulation_.tds().cells().is_used(
            delaunay_cell); // a new cell in an old one's place is as welcome
    };
    for (std::size_t c = 0; c < postponed_cells_.size(); ++c)
    {
        // Half of the time here would be spent on waiting for the cells beyond the facets.
        if (c + kPrefetchDistance < postponed_cells_.size() &&
            is_used(postponed_cells_[c + kPrefetchDistance]))
        {
            for (int i = 0; i < 4; ++i)
                prefetch(postponed_cells_[c + kPrefetchDistance]->neighbor(i));
        }
        const DelaunayCell delaunay_cell = postponed_cells_[c];
        if (!is_used(delaunay_cell))
            continue;
        for (int i = 0; i < 4; ++i)
        {
            if (delaunay_cell->info().facet[static_cast<std::size_t>(i)] == kUnqueriedFacet)
                query_dual_edge(delaunay_cell, i, kNoFacet);
        }
    }
    postponed_cells_.clear();
}

// Asks the oracle where the dual edge of a facet crosses the surface, and keeps the answer on both sides of
// the facet. Of several crossings the one with the largest ball becomes the center: it is the farthest from
// what is resolved already.
void RestrictedDelaunay::query_dual_edge(DelaunayCell delaunay_cell, int index, FacetId reuse)
{
    const DelaunayCell neighbor = delaunay_cell->neighbor(index);
    crossings_.clear();
    if (!triangulation_.is_infinite(delaunay_cell) && !triangulation_.is_infinite(neighbor))
    {
        oracle_.find_crossings({delaunay_cell->info().circumcenter, neighbor->info().circumcenter},
                               crossings_);
        ++statistics_.queries_refinement;
    }
    if (reuse != kNoFacet)
        release_facet(reuse);
    const FacetId id = crossings_.empty() ? kNoFacet : allocate_facet();
    const int mirror = triangulation_.mirror_index(delaunay_cell, index);
    delaunay_cell->info().facet[static_cast<std::size_t>(index)] = id;
    neighbor->info().facet[static_cast<std::size_t>(mirror)] = id;
    if (id == kNoFacet)
        return;

    RestrictedFacet& facet = facets_[id];
    facet.delaunay_cell = delaunay_cell;
    facet.index = static_cast<std::uint8_t>(index);
    facet.crossing_count = capped_count(crossings_.size());
    for (std::size_t k = 0; k < 3; ++k)
        facet.vertices[k] = delaunay_cell->vertex((index + static_cast<int>(k) + 1) & 3)->info().index;
    facet.kept = false;
    facet.squared_radius = -1.0;
    const Point3 corner = position(delaunay_cell->vertex((index + 1) & 3));
    for (const Crossing& crossing : crossings_)
    {
        const double squared_radius = squared_distance(crossing.point, corner);
        if (squared_radius > facet.squared_radius)
        {
            facet.squared_radius = squared_radius;
            facet.center = crossing.point;
        }
    }
    mark_unchecked(facet);
    changed_facets_.push_back(id);
}

void RestrictedDelaunay::mark_unchecked(const RestrictedFacet& facet)
{
    if (!facet.odd())
        return;
    for (int i = 0; i < 4; ++i)
    {
        if (i != facet.index)
            mark_unchecked(facet.delaunay_cell->vertex(i));
    }
}

void RestrictedDelaunay::mark_unchecked(VertexHandle vertex)
{
    VertexData& data = vertex->info();
    if (data.umbrella_unchecked || data.origin == VertexOrigin::kSentinel)
        return;
    data.umbrella_unchecked = true;
    data.pinched = true; // until looked at again
    unchecked_vertices_.push_back(vertex);
}

std::vector<VertexHandle> RestrictedDelaunay::take_unchecked_vertices()
{
    for (const VertexHandle vertex : unchecked_vertices_)
        vertex->info().umbrella_unchecked = false;
    return std::exchange(unchecked_vertices_, {});
}

void RestrictedDelaunay::odd_facets_around(VertexHandle vertex, std::vector<FacetId>& facets)
{
    facets.clear();
    star_.clear();
    triangulation_.incident_cells(vertex, std::back_inserter(star_));
    for (const DelaunayCell delaunay_cell : star_)
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

FacetId RestrictedDelaunay::allocate_facet()
{
    if (free_facets_.empty())
    {
        CHECK_LT(facets_.size(), static_cast<std::size_t>(kUnqueriedFacet));
        facets_.emplace_back();
        return static_cast<FacetId>(facets_.size() - 1);
    }
    const FacetId id = free_facets_.back();
    free_facets_.pop_back();
    return id;
}

void RestrictedDelaunay::release_facet(FacetId id)
{
    RestrictedFacet& facet = facets_[id];
    mark_unchecked(facet);
    facet.crossing_count = 0;
    ++facet.generation;
    free_facets_.push_back(id);
}

} // namespace voroprobe
