#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "mesher/insertion.h"
#include "mesher/insertion_workspace.h"
#include "mesher/restricted_facet.h"
#include "mesher/seeded_mesher.h"
#include "oracles/surface_oracle.h"
#include "support/workers.h"

namespace voroprobe
{

//! The Delaunay triangulation of a growing point set restricted to the surface of an oracle.
//!
//! Every Delaunay cell knows its circumcenter and the region that holds it. A facet is odd exactly where the
//! regions of its two cells differ in sign, so the odd facets bound the union of the inside cells: they are
//! closed and orientable whatever rounding does to a circumcenter.
//!
//! An insertion is prepared without touching the triangulation, and then carried out.
class RestrictedDelaunay
{
public:
    //! `statistics` counts insertions, queries and look-ups; both references must outlive the object.
    RestrictedDelaunay(const SurfaceOracle& oracle, MeshingStatistics& statistics);

    //! Finds out what inserting p would do; `start`: a Delaunay cell in conflict with it.
    void prepare(const Point3& p, DelaunayCell start, Insertion& insertion) const
    {
        insertion.prepare(triangulation_, facets_, oracle_, p, start);
    }

    //! Carries out an insertion. \pre Nothing was inserted since it was prepared.
    VertexHandle insert(const Insertion& insertion, VertexOrigin origin);

    //! For insertions side by side, each thread within a subdomain of its own: gives stocks for as many
    //! `insertions`, as a rule, to the workspaces. Until end_round() nothing but the next two, which are for
    //! the threads, may be called, and what is const of facets of the subdomain.
    void begin_round(std::span<InsertionWorkspace* const> workspaces, std::size_t insertions);

    //! False where the conflict zone is not within the subdomain.
    bool prepare(const Point3& p, DelaunayCell start, const Subdomain& subdomain, Insertion& insertion) const
    {
        return insertion.prepare(triangulation_, facets_, oracle_, p, start, &subdomain);
    }

    //! Whether the stock is enough for an insertion.
    [[nodiscard]] static bool has_enough(const InsertionWorkspace& workspace, const Insertion& insertion);

    VertexHandle insert(const Insertion& insertion, VertexOrigin origin, InsertionWorkspace& workspace);

    //! Makes what the threads have left one thing, in the order of the workspaces. The stocks stay with them.
    void end_round(std::span<InsertionWorkspace* const> workspaces, const Workers& workers);

    //! Takes the stocks back.
    void take_back(InsertionWorkspace& workspace);

    //! A Delaunay cell in conflict with a point; located from `hint`, which may be null. Null where the point
    //! is a vertex already.
    [[nodiscard]] DelaunayCell locate(const Point3& p, VertexHandle hint) const;

    //! Inserts any point of the surface, as the three above do together. Null where it is a vertex already.
    VertexHandle insert(const Point3& p, VertexOrigin origin, VertexHandle hint = {});

    //! Whether no vertex is closer to p than `least_separation`. Located from `hint`, which may be null.
    [[nodiscard]] bool is_apart(const Point3& p, double least_separation, VertexHandle hint = {}) const;

    //! Asks the oracle about the dual edges that insertions have left aside: those whose ends lie on one side
    //! of the surface. Their facets cannot be in the mesh, and while it is coarse most of them vanish
    //! unasked. The facets found are in changed_facets(). Cost: O(Delaunay cells made since the last call).
    void query_even_facets(const Workers& workers);

    //! The facets that the last insertion, or query_even_facets(), found.
    [[nodiscard]] const std::vector<FacetId>& changed_facets() const { return workspace_.changed_facets; }

    //! Has the vertex taken by the next take_unchecked_vertices().
    void mark_unchecked(VertexHandle vertex) { mark_unchecked(vertex, workspace_); }

    //! Takes the vertices, sentinels left out, whose odd facets changed since they were last taken.
    std::vector<VertexHandle> take_unchecked_vertices();

    //! Takes the vertices inserted since the last time whose Voronoi cells are not part of probed ones.
    std::vector<VertexHandle> take_unprobed_vertices()
    {
        return std::exchange(workspace_.unprobed_vertices, {});
    }

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
    [[nodiscard]] std::size_t vertex_index_bound() const { return vertex_index_bound_; }

    [[nodiscard]] const Triangulation& triangulation() const { return triangulation_; }
    [[nodiscard]] const SurfaceOracle& oracle() const { return oracle_; }
    [[nodiscard]] std::size_t vertex_count() const { return vertex_index_bound_ - kSentinelCount; }

private:
    //! A facet whose dual edge the oracle is to be asked about.
    struct Unqueried
    {
        DelaunayCell delaunay_cell;
        std::uint8_t index;
    };

    void insert_sentinels();
    void forget_zone(const Insertion& insertion, InsertionWorkspace& workspace);
    void check_persistence(const Insertion& insertion) const;
    VertexHandle make_vertex(const Insertion& insertion, VertexOrigin origin, InsertionWorkspace& workspace);
    void delete_zone(const Insertion& insertion, InsertionWorkspace& workspace);
    DelaunayCell make_cell(const std::array<VertexHandle, 4>& corners, InsertionWorkspace& workspace);
    void make_star(const Insertion& insertion, VertexHandle vertex, InsertionWorkspace& workspace);
    void connect_star(const Insertion& insertion, const InsertionWorkspace& workspace);
    static void postpone_unqueried_facets(InsertionWorkspace& workspace);
    void forget_dead_postponed_cells();
    void fill_stock(InsertionWorkspace& workspace, std::size_t insertions);
    void close_ranks(InsertionWorkspace::Stock& stock, std::uint32_t shift);
    void count(InsertionWorkspace& workspace);
    std::vector<Unqueried> take_unqueried_facets(std::span<const DelaunayCell> delaunay_cells);
    void query(const Unqueried& unqueried, RestrictedFacet& facet) const;
    void add_facet(DelaunayCell delaunay_cell, RestrictedFacet facet, InsertionWorkspace& workspace);
    static void mark_unchecked(const RestrictedFacet& facet, InsertionWorkspace& workspace);
    static void mark_unchecked(VertexHandle vertex, InsertionWorkspace& workspace);
    FacetId allocate_facet(InsertionWorkspace& workspace);
    void release_facet(FacetId id, InsertionWorkspace& workspace);

    const SurfaceOracle& oracle_;
    MeshingStatistics& statistics_;
    Triangulation triangulation_;
    std::vector<RestrictedFacet> facets_;
    std::uint32_t vertex_index_bound_ = 0;
    InsertionWorkspace workspace_;
    std::size_t postponed_limit_ = 0; //!< postponed cells are cleared of dead ones when there are as many

    Insertion insertion_;                    //!< scratch
    std::vector<DelaunayCell> cells_around_; //!< scratch
};

} // namespace voroprobe
