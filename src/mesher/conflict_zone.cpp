#include "mesher/conflict_zone.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voroprobe
{
namespace
{

constexpr std::size_t kSmallestTable = 256;

// Squared distances from a circumcenter that differ by this fraction of the squared radius differ for
// certain: circumcenter() is exact to nine digits of the radius.
constexpr double kCertainExcess = 1e-7;
constexpr auto kUnconnected = std::uint32_t{0xffffffff};

std::size_t hash(const void* cell)
{
    // Cells lie about 128 bytes apart.
    const auto address = reinterpret_cast<std::uintptr_t>(cell) >> 3U;
    return static_cast<std::size_t>((address * std::uint64_t{0x9e3779b97f4a7c15}) >> 32U);
}

//! Whether the circumscribing ball of a cell holds p. Mostly the circumcenter tells; near the sphere, where
//! that is not exact, the predicate does, and of cospherical points a symbolic perturbation.
bool is_in_conflict(const Triangulation& triangulation, DelaunayCell delaunay_cell, const Point3& p)
{
    if (!triangulation.is_infinite(delaunay_cell))
    {
        const Point3& center = delaunay_cell->info().circumcenter;
        const double squared_radius = squared_distance(position(delaunay_cell->vertex(0)), center);
        const double excess = squared_distance(p, center) - squared_radius;
        if (std::abs(excess) > kCertainExcess * squared_radius)
            return excess < 0.0;
    }
    return triangulation.side_of_sphere(delaunay_cell, cgal_point(p), true) == CGAL::ON_BOUNDED_SIDE;
}

//! Whether no vertex but sentinels is outside the subdomain.
bool lies_in(const Subdomain& subdomain, DelaunayCell delaunay_cell)
{
    for (int i = 0; i < 4; ++i)
    {
        const VertexHandle vertex = delaunay_cell->vertex(i);
        if (!subdomain.holds(position(vertex)) && vertex->info().origin != VertexOrigin::kSentinel)
            return false;
    }
    return true;
}

} // namespace

void ConflictZone::forget()
{
    cells_.clear();
    beyond_.clear();
    facets_.clear();
    cell_of_facet_.clear();
    entries_ = 0;
    if (++zone_ == 0 || table_.empty())
    {
        table_.assign(std::max(kSmallestTable, table_.size()), Seen{});
        zone_ = 1;
    }
}

void ConflictZone::grow_table()
{
    std::vector<Seen> old(2 * table_.size());
    std::swap(old, table_);
    entries_ = 0;
    for (const Seen& seen : old)
    {
        if (seen.zone != zone_)
            continue;
        std::size_t slot = hash(seen.cell) & (table_.size() - 1);
        while (table_[slot].zone == zone_)
            slot = (slot + 1) & (table_.size() - 1);
        table_[slot] = seen;
        ++entries_;
    }
}

//! The entry of a cell, made where there is none. Valid until the next call.
ConflictZone::Seen& ConflictZone::look_up(DelaunayCell delaunay_cell)
{
    if (2 * entries_ >= table_.size())
        grow_table();
    const void* const key = &*delaunay_cell;
    std::size_t slot = hash(key) & (table_.size() - 1);
    while (table_[slot].zone == zone_ && table_[slot].cell != key)
        slot = (slot + 1) & (table_.size() - 1);
    Seen& entry = table_[slot];
    if (entry.zone != zone_)
    {
        entry = {key, zone_, kUnseen};
        ++entries_;
    }
    return entry;
}

void ConflictZone::add_cell(DelaunayCell delaunay_cell, Seen& entry)
{
    for (int i = 0; i < 4; ++i)
        prefetch(delaunay_cell->neighbor(i)); // looked at soon
    entry.place = static_cast<std::int32_t>(cells_.size());
    cells_.push_back(delaunay_cell);
    beyond_.push_back({});
}

bool ConflictZone::find(const Triangulation& triangulation, const Point3& p, DelaunayCell start,
                        const Subdomain* subdomain)
{
    forget();
    if (subdomain != nullptr && !lies_in(*subdomain, start))
        return false;
    add_cell(start, look_up(start));
    for (std::size_t place = 0; place < cells_.size(); ++place)
    {
        for (int i = 0; i < 4; ++i)
        {
            if (!look_beyond(place, i, triangulation, p, subdomain))
                return false;
        }
    }
    for (std::uint32_t f = 0; f < facets_.size(); ++f)
    {
        for (std::uint8_t i = 0; i < 4; ++i)
        {
            if (i != facets_[f].inner_index && facets_[f].beyond[i].star_cell == kUnconnected)
                connect(f, i);
        }
    }
    return true;
}

bool ConflictZone::look_beyond(std::size_t place, int i, const Triangulation& triangulation, const Point3& p,
                               const Subdomain* subdomain)
{
    const DelaunayCell next = cells_[place]->neighbor(i);
    Seen& entry = look_up(next);
    if (entry.place == kUnseen)
    {
        if (!is_in_conflict(triangulation, next, p))
            entry.place = kStays;
        else if (subdomain != nullptr && !lies_in(*subdomain, next))
            return false;
        else
            add_cell(next, entry);
    }
    if (entry.place == kStays)
        add_facet(place, i, next);
    else
        beyond_[place][static_cast<std::size_t>(i)] = entry.place;
    return true;
}

void ConflictZone::add_facet(std::size_t place, int i, DelaunayCell outer)
{
    ZoneFacet facet;
    facet.inner = cells_[place];
    facet.outer = outer;
    facet.inner_index = static_cast<std::uint8_t>(i);
    facet.outer_index = static_cast<std::uint8_t>(mirror_index(facet.inner, i, outer));
    for (int corner = 0; corner < 4; ++corner)
    {
        facet.corners[static_cast<std::size_t>(corner)] = facet.inner->vertex(corner);
        facet.beyond[static_cast<std::size_t>(corner)].star_cell = kUnconnected;
    }
    facet.corners[static_cast<std::size_t>(i)] = VertexHandle();
    beyond_[place][static_cast<std::size_t>(i)] = ~static_cast<std::int32_t>(facets_.size());
    facets_.push_back(facet);
    cell_of_facet_.push_back(static_cast<std::uint32_t>(place));
}

// The new cells of two boundary facets with a common edge are neighbours. From one to the other leads a turn
// around the edge through the zone.
void ConflictZone::connect(std::uint32_t star_cell, std::uint8_t index)
{
    DelaunayCell at = facets_[star_cell].inner;
    std::int32_t place = static_cast<std::int32_t>(cell_of_facet_[star_cell]);
    VertexHandle pivot = at->vertex(facets_[star_cell].inner_index); // with the edge, spans the way out
    int out = index;
    while (true)
    {
        place = beyond_[static_cast<std::size_t>(place)][static_cast<std::size_t>(out)];
        if (place < 0)
            break;
        const DelaunayCell next = cells_[static_cast<std::size_t>(place)];
        const VertexHandle next_pivot = next->vertex(next->index(at));
        out = next->index(pivot);
        pivot = next_pivot;
        at = next;
    }
    const auto other = static_cast<std::uint32_t>(~place);
    const auto other_index = static_cast<std::uint8_t>(at->index(pivot));
    facets_[star_cell].beyond[index] = {other, other_index};
    facets_[other].beyond[other_index] = {star_cell, index};
}

} // namespace voroprobe
