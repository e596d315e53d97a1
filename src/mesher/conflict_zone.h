#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesher/delaunay.h"
#include "mesher/subdomain.h"

namespace voroprobe
{

//! A facet between a conflict zone and the Delaunay cells that stay, and the cell that a new vertex makes
//! with it: the zone's cell with the vertex opposite the facet replaced.
struct ZoneFacet
{
    //! A cell of the new star and the index of one of its vertices.
    struct StarFacet
    {
        std::uint32_t star_cell = 0;
        std::uint8_t index = 0;
    };

    DelaunayCell inner{}; //!< the cell of the zone
    DelaunayCell outer{}; //!< the cell that stays
    std::uint8_t inner_index = 0;
    std::uint8_t outer_index = 0;
    std::array<VertexHandle, 4> corners{}; //!< of the new cell; null at inner_index, for the new vertex
    //! Of the new cells beyond the three facets at the new vertex, by the corner opposite; unused at
    //! inner_index.
    std::array<StarFacet, 4> beyond{};
};

//! The Delaunay cells whose circumscribing balls hold a point, and what a vertex there would put in their
//! place. The triangulation is only read: zones of different points can be found by several threads at once.
//! Source: Bowyer 1981; Watson 1981.
class ConflictZone
{
public:
    //! `start`: a cell in conflict with p. \pre p lies in the convex hull and is no vertex. Cost: linear in
    //! the zone.
    void find(const Triangulation& triangulation, const Point3& p, DelaunayCell start)
    {
        find(triangulation, p, start, nullptr);
    }

    //! False where a vertex of the zone, sentinels left out, lies outside the subdomain. Of cells with such a
    //! vertex only what never changes while they exist is read. `subdomain` may be null: all of space.
    bool find(const Triangulation& triangulation, const Point3& p, DelaunayCell start,
              const Subdomain* subdomain);

    [[nodiscard]] const std::vector<DelaunayCell>& cells() const { return cells_; }

    //! Facet i makes cell i of the new star.
    [[nodiscard]] const std::vector<ZoneFacet>& facets() const { return facets_; }

private:
    //! What lies beyond the facets of a cell of the zone: cells of the zone from 0, boundary facets as ~i.
    using Beyond = std::array<std::int32_t, 4>;

    static constexpr std::int32_t kUnseen = -2; //!< what a look-up answers
    static constexpr std::int32_t kStays = -1;

    //! An entry of an open hash table; those of earlier zones are void.
    struct Seen
    {
        const void* cell = nullptr;
        std::uint32_t zone = 0;
        std::int32_t place = kUnseen; //!< in cells_, or kStays
    };

    void forget();
    void grow_table();
    Seen& look_up(DelaunayCell delaunay_cell);
    void add_cell(DelaunayCell delaunay_cell, Seen& entry);
    bool look_beyond(std::size_t place, int i, const Triangulation& triangulation, const Point3& p,
                     const Subdomain* subdomain);
    void add_facet(std::size_t place, int i, DelaunayCell outer);
    void connect(std::uint32_t star_cell, std::uint8_t index);

    std::vector<DelaunayCell> cells_;
    std::vector<Beyond> beyond_; //!< of each of the cells
    std::vector<ZoneFacet> facets_;
    std::vector<std::uint32_t> cell_of_facet_; //!< place of ZoneFacet::inner
    std::vector<Seen> table_;                  //!< its size is a power of two
    std::size_t entries_ = 0;
    std::uint32_t zone_ = 0; //!< counts zones
};

} // namespace voroprobe
