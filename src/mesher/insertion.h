#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesher/conflict_zone.h"
#include "mesher/restricted_facet.h"

namespace voroprobe
{

//! What inserting a point does to the Delaunay triangulation restricted to a surface, found without touching
//! it.
//!
//! The oracle is asked about the facets incident to the new vertex only. A facet on the boundary of the
//! conflict zone keeps its answer, for its dual edge only shrinks: "no crossing" stays true, and a single
//! crossing stays the center while it is no nearer to the new point than to the facet's vertices. Facets
//! whose two cells lie on one side are left unqueried.
class Insertion
{
public:
    //! A cell of the new star, on the boundary facet of the zone with the same index.
    struct StarCell
    {
        Point3 circumcenter;
        Region region = kOuterRegion;
        std::array<FacetId, 4> facet{}; //!< as in DelaunayCellData; those of new facets are set later
    };

    //! A facet that the point makes, or whose answer is new.
    struct NewFacet
    {
        RestrictedFacet facet; //!< all but the cell it belongs to, the indices of its corners, and its id
        std::uint32_t star_cell = 0;
    };

    //! Finds out about inserting p. `facets`: of the triangulation, by id. `start`: a cell in conflict with
    //! p. `subdomain`: null for all of space; else false, with nothing found out, where the conflict zone is
    //! not within it. \pre p is no vertex.
    bool prepare(const Triangulation& triangulation, std::span<const RestrictedFacet> facets,
                 const SurfaceOracle& oracle, const Point3& p, DelaunayCell start,
                 const Subdomain* subdomain = nullptr);

    [[nodiscard]] const Point3& point() const { return point_; }
    [[nodiscard]] SurfaceId surface() const { return surface_; } //!< that the point lies on
    [[nodiscard]] const ConflictZone& zone() const { return zone_; }
    [[nodiscard]] const std::vector<StarCell>& star() const { return star_; }
    [[nodiscard]] const std::vector<NewFacet>& new_facets() const { return new_facets_; }
    [[nodiscard]] std::size_t queries() const { return queries_; }

    //! Whether the Voronoi cells of all vertices around were probed.
    [[nodiscard]] bool all_around_probed() const { return all_around_probed_; }

private:
    void make_star_cell(const ZoneFacet& zone_facet);
    void carry_over(std::uint32_t f, std::span<const RestrictedFacet> facets);
    void query_within_star(std::uint32_t f);
    void query(std::uint32_t star_cell, std::uint8_t index, const Segment3& dual_edge);

    const SurfaceOracle* oracle_ = nullptr;
    Point3 point_;
    SurfaceId surface_ = kNoSurface;
    bool all_around_probed_ = false;
    std::size_t queries_ = 0;
    ConflictZone zone_;
    std::vector<StarCell> star_;
    std::vector<NewFacet> new_facets_;
    std::vector<Crossing> crossings_; //!< scratch
};

} // namespace voroprobe
