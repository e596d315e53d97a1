#include "mesher/insertion.h"

#include <algorithm>

#include "mesher/circumcenter.h"

namespace voroprobe
{

bool Insertion::prepare(const Triangulation& triangulation, std::span<const RestrictedFacet> facets,
                        const SurfaceOracle& oracle, const Point3& p, DelaunayCell start,
                        const Subdomain* subdomain)
{
    if (!zone_.find(triangulation, p, start, subdomain))
        return false;
    oracle_ = &oracle;
    point_ = p;
    surface_ = oracle.surface_at(p);
    all_around_probed_ = true;
    queries_ = 0;
    star_.clear();
    new_facets_.clear();
    for (const ZoneFacet& zone_facet : zone_.facets())
        make_star_cell(zone_facet);
    for (std::uint32_t f = 0; f < star_.size(); ++f)
        carry_over(f, facets);
    for (std::uint32_t f = 0; f < star_.size(); ++f)
        query_within_star(f);
    // The newest bad facet is refined first: of one insertion let that be the largest.
    std::sort(new_facets_.begin(), new_facets_.end(),
              [](const NewFacet& a, const NewFacet& b)
              { return a.facet.squared_radius < b.facet.squared_radius; });
    return true;
}

void Insertion::make_star_cell(const ZoneFacet& zone_facet)
{
    std::array<Point3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
    {
        const VertexHandle corner = zone_facet.corners[i];
        corners[i] = i == zone_facet.inner_index ? point_ : position(corner);
        all_around_probed_ =
            all_around_probed_ && (i == zone_facet.inner_index || corner->info().cell_probed);
    }
    StarCell& cell = star_.emplace_back();
    cell.circumcenter = circumcenter(corners);
    cell.region = oracle_->region(cell.circumcenter);
}

// A facet on the boundary of the zone keeps what was known of it where that still holds.
void Insertion::carry_over(std::uint32_t f, std::span<const RestrictedFacet> facets)
{
    const ZoneFacet& zone_facet = zone_.facets()[f];
    const DelaunayCellData& outer = zone_facet.outer->info();
    const FacetId known = outer.facet[zone_facet.outer_index];
    FacetId& slot = star_[f].facet[zone_facet.inner_index];
    const bool odd = is_inside(outer.region) != is_inside(star_[f].region);
    if (!odd && known >= kUnqueriedFacet)
    {
        slot = known;
        return;
    }
    if (known < kUnqueriedFacet && facets[known].crossing_count == 1)
    {
        const bool center_stays =
            squared_distance(facets[known].center, point_) >= facets[known].squared_radius;
        if (odd == center_stays)
        {
            slot = odd ? known : kNoFacet;
            return;
        }
    }
    // One of several crossings may have gone, or rounding moved a Voronoi vertex across the surface.
    slot = kNoFacet;
    query(f, zone_facet.inner_index, {outer.circumcenter, star_[f].circumcenter});
}

// The facets at the new vertex, each from one of its cells.
void Insertion::query_within_star(std::uint32_t f)
{
    const ZoneFacet& zone_facet = zone_.facets()[f];
    for (std::uint8_t i = 0; i < 4; ++i)
    {
        const auto [g, index_of_g] = zone_facet.beyond[i];
        if (i == zone_facet.inner_index || g < f)
            continue;
        const bool odd = is_inside(star_[f].region) != is_inside(star_[g].region);
        star_[f].facet[i] = odd ? kNoFacet : kUnqueriedFacet;
        star_[g].facet[index_of_g] = star_[f].facet[i];
        if (odd)
            query(f, i, {star_[f].circumcenter, star_[g].circumcenter});
    }
}

void Insertion::query(std::uint32_t star_cell, std::uint8_t index, const Segment3& dual_edge)
{
    oracle_->find_crossings(dual_edge, crossings_);
    ++queries_;
    if (crossings_.empty())
        return;
    const ZoneFacet& zone_facet = zone_.facets()[star_cell];
    NewFacet& found = new_facets_.emplace_back();
    found.star_cell = star_cell;
    found.facet.index = index;
    const std::size_t corner = (index + 1U) & 3U;
    set_crossings(found.facet, crossings_,
                  corner == zone_facet.inner_index ? point_ : position(zone_facet.corners[corner]));
}

} // namespace voroprobe
