#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesher/bad_facet_queue.h"
#include "mesher/criteria.h"
#include "mesher/restricted_delaunay.h"
#include "mesher/seeded_mesher.h"
#include "mesher/side_by_side_refinement.h"
#include "support/progress.h"

namespace voroprobe
{

//! Delaunay refinement: inserts the centers of the surface Delaunay balls of bad facets until there is none.
//! This follows: Boissonnat & Oudot, Provably good sampling and meshing of surfaces, 2005, with the manifold
//! criterion of CGAL's Surface_mesher, both down to a floor radius.
class Refinement
{
public:
    //! All arguments but `options` must outlive the object; `progress` may be null.
    Refinement(RestrictedDelaunay& restricted, const MeshingOptions& options, const Workers& workers,
               MeshingStatistics& statistics, ProgressSink* progress);

    //! As RestrictedDelaunay::insert; judges the facets that changed.
    VertexHandle insert(const Point3& p, VertexOrigin origin, VertexHandle hint = {});

    //! Until no facet is bad and every vertex that can have an umbrella has one; stops early when asked to.
    void refine();

    //! Lowers the floor around the places (see LocalFloor::lower) and judges what lies there again. False
    //! where no floor changed.
    bool lower_floor(std::span<const Point3> places, int round);

    //! A vertex that is on no facet of the mesh; nullopt when there is none left to initialize. Call after
    //! refine().
    std::optional<VertexHandle> take_isolated_vertex();

    //! How refinement has ended so far: kDone unless it was stopped.
    [[nodiscard]] MeshingStatus status() const { return status_; }

private:
    bool may_go_on();
    void judge_changed_facets();
    void judge(FacetId id);
    void refine_facet(FacetId id);
    bool find_unresolved_facets();
    bool find_pinched_vertices();

    RestrictedDelaunay& restricted_;
    const Workers& workers_;
    MeshingStatistics& statistics_;
    ProgressSink* progress_;
    FacetCriteria criteria_;
    SideBySideRefinement side_by_side_;
    std::size_t max_vertices_;
    std::size_t next_report_ = 0; //!< insertions
    BadFacetQueue bad_facets_;
    Insertion insertion_; //!< scratch
    std::vector<VertexHandle> isolated_vertices_;
    std::vector<FacetId> facets_; //!< scratch
    MeshingStatus status_ = MeshingStatus::kDone;
};

} // namespace voroprobe
