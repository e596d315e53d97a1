#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mesher/delaunay.h"
#include "mesher/seeded_mesher.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! A Delaunay facet whose dual Voronoi edge meets the surface.
struct RestrictedFacet
{
    Point3 center;                //!< of the surface Delaunay ball: where the dual edge crosses the surface
    double squared_radius = 0.0;  //!< of the surface Delaunay ball
    DelaunayCell delaunay_cell{}; //!< the facet is the one opposite ...
    std::uint8_t index = 0;       //!< ... this vertex of the Delaunay cell
    bool kept = false;            //!< rounding hides the conflict of its center: not refined any more

    //! Crossings of the dual edge, capped at 255 with the parity kept; 0: the slot is free.
    std::uint8_t crossing_count = 0;
    std::array<std::uint32_t, 3> vertices{}; //!< indices of the corners
    std::uint32_t generation = 0;            //!< changes whenever the slot is reused or the facet recomputed

    //! Odd facets separate inside from outside: they are the mesh. Even ones are evidence of unresolved
    //! surface.
    [[nodiscard]] bool odd() const { return (crossing_count & 1U) != 0; }
};

//! The Delaunay triangulation of a growing point set restricted to the surface of an oracle.
//!
//! Every Delaunay cell knows its circumcenter and the region that holds it. A facet is odd exactly where the
//! regions of its two cells differ in sign, so the odd facets bound the union of the inside cells: they are
//! closed and orientable whatever rounding does to a circumcenter.
//!
//! An insertion queries the oracle for the facets incident to the new vertex only. A facet on the boundary of
//! the conflict zone keeps its answer, for its dual edge only shrinks: "no crossing" stays true, and a single
//! crossing stays the center while it is no nearer to the new point than to the facet's vertices.
class RestrictedDelaunay
{
public:
    //! `statistics` counts insertions, queries and look-ups; both references must outlive the object.
    RestrictedDelaunay(const SurfaceOracle& oracle, MeshingStatistics& statistics);

    //! Inserts the center of a facet's surface Delaunay ball. `start`: a Delaunay cell in conflict with it.
    VertexHandle insert(const Point3& p, DelaunayCell start, VertexOrigin origin);

    //! Inserts any point of the surface; located from `hint`, which may be null. Returns a null handle, and
    //! changes nothing, where the point is a vertex already.
    VertexHandle insert(const Point3& p, VertexOrigin origin, VertexHandle hint = {});

    //! Whether no vertex is closer to p than `least_separation`. Located from `hint`.
    [[nodiscard]] bool is_apart(const Point3& p, double least_separation, VertexHandle hint) const;

    //! Asks the oracle about the dual edges that insertions have left aside: those whose ends lie on one side
    //! of the surface. Their facets cannot be in the mesh, and while it is coarse most of them vanish
    //! unasked. The facets found are in changed_facets(). Cost: O(Delaunay cells made since the last call).
    void query_even_facets();

    //! The facets that the last insertion created or changed.
    [[nodiscard]] const std::vector<FacetId>& changed_facets() const { return changed_facets_; }

    //! Has the vertex taken by the next take_unchecked_vertices().
    void mark_unchecked(VertexHandle vertex);

    //! Takes the vertices, sentinels left out, whose odd facets changed since they were last taken.
    std::vector<VertexHandle> take_unchecked_vertices();

    //! Takes the vertices inserted since the last time whose Voronoi cells are not part of probed ones.
    std::vector<VertexHandle> take_unprobed_vertices() { return std::exchange(unprobed_vertices_, {}); }

    //! Facet ids run below this; slots whose crossing_count is 0 are free.
    [[nodiscard]] FacetId facet_slots() const { return static_cast<FacetId>(facets_.size()); }

    //! The odd facets incident to a vertex, into `facets` (cleared first).
    void odd_facets_around(VertexHandle vertex, std::vector<FacetId>& facets);

    //! Number of facets whose dual edge crosses the surface more than once.
    [[nodiscard]] std::size_t count_unresolved_facets() const;

    //! One of the two Delaunay cells of the facet that is in conflict with its center; null where rounding
    //! hides both.
    [[nodiscard]] DelaunayCell conflicting_cell(const RestrictedFacet& facet) const;

    //! The surface between the regions of the facet's two cells; kNoSurface where they are no neighbours.
    [[nodiscard]] SurfaceId surface(const RestrictedFacet& facet) const;

    //! Whether an odd facet lies on one surface: its vertices are on the one that its cells' regions bound.
    [[nodiscard]] bool is_faithful(const RestrictedFacet& facet) const;

    [[nodiscard]] const RestrictedFacet& facet(FacetId id) const { return facets_[id]; }
    RestrictedFacet& facet(FacetId id) { return facets_[id]; }
    [[nodiscard]] std::array<Point3, 3> corners(const RestrictedFacet& facet) const;

    //! VertexData::index runs below this.
    [[nodiscard]] std::size_t vertex_index_bound() const { return triangulation_.number_of_vertices(); }

    [[nodiscard]] const Triangulation& triangulation() const { return triangulation_; }
    [[nodiscard]] const SurfaceOracle& oracle() const { return oracle_; }
    [[nodiscard]] std::size_t vertex_count() const
    {
        return triangulation_.number_of_vertices() - kSentinelCount;
    }

private:
    //! A facet between the conflict zone and the Delaunay cells that stay.
    struct ZoneBoundaryFacet
    {
        DelaunayCell outer; //!< the cell that stays
        int outer_index;
        FacetId facet;
    };

    void insert_sentinels();
    void forget_zone();
    void set_dual_vertex(DelaunayCell delaunay_cell);
    void forget_dead_postponed_cells();
    void query_or_postpone(DelaunayCell delaunay_cell, int index);
    void carry_over(const ZoneBoundaryFacet& boundary, const Point3& inserted);
    void query_dual_edge(DelaunayCell delaunay_cell, int index, FacetId reuse);
    void note_unprobed(VertexHandle vertex);
    void mark_unchecked(const RestrictedFacet& facet);
    FacetId allocate_facet();
    void release_facet(FacetId id);

    const SurfaceOracle& oracle_;
    MeshingStatistics& statistics_;
    Triangulation triangulation_;
    std::vector<RestrictedFacet> facets_;
    std::vector<FacetId> free_facets_;
    std::vector<FacetId> changed_facets_;
    std::vector<VertexHandle> unchecked_vertices_;
    std::vector<VertexHandle> unprobed_vertices_;
    std::size_t postponed_limit_ = 0; //!< postponed_cells_ is cleared of dead cells when it is as long
    std::vector<DelaunayCell> postponed_cells_; //!< with facets not asked about; some are gone since

    // Scratch of one insertion, kept to avoid allocation.
    std::vector<DelaunayCell> zone_cells_;
    std::vector<Triangulation::Facet> zone_boundary_;
    std::vector<ZoneBoundaryFacet> boundary_;
    std::vector<Crossing> crossings_;
    std::vector<DelaunayCell> star_;
};

} // namespace voroprobe
