#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "mesher/bad_facet_queue.h"
#include "mesher/criteria.h"
#include "mesher/restricted_delaunay.h"
#include "mesher/subdomain.h"
#include "support/workers.h"

namespace voroprobe
{

//! Delaunay refinement in several subdomains side by side, in rounds.
//!
//! Space is cut across an axis. A Delaunay cell belongs to the subdomain that holds all of its vertices, and
//! to none where they lie in several. A subdomain's thread inserts only where the whole conflict zone belongs
//! to it; the other bad facets wait for a round with other cuts, or for the insertions one after the other in
//! between. Two cells with a common facet never belong to two subdomains, so no thread reads what another
//! writes, and what comes out hangs on the cuts alone, not on the number of threads.
class SideBySideRefinement
{
public:
    //! All arguments must outlive the object.
    SideBySideRefinement(RestrictedDelaunay& restricted, const FacetCriteria& criteria,
                         const Workers& workers, MeshingStatistics& statistics);

    //! Whether there are bad facets enough for a round, and the mesh is fine enough for most to be within a
    //! subdomain.
    [[nodiscard]] bool pays(const BadFacetQueue& bad_facets) const;

    //! The vertices that a round inserts at most.
    [[nodiscard]] static std::size_t most_insertions(const BadFacetQueue& bad_facets);

    //! One round. The facets that it leaves come back into the queue.
    void refine(BadFacetQueue& bad_facets);

    //! Gives memory set aside back to the triangulation, which may be walked through again then.
    void finish() { set_part_count(0); }

private:
    struct Part
    {
        Subdomain subdomain;
        InsertionWorkspace workspace;
        BadFacetQueue bad_facets;
        BadFacetQueue waiting; //!< their conflict zones are not within the subdomain
        Insertion insertion;
        std::size_t insertions = 0;
        std::size_t stale_queue_entries = 0;
    };

    void set_part_count(std::size_t count);
    void cut(const BadFacetQueue& bad_facets);
    void share_out(BadFacetQueue& bad_facets);
    void refine(Part& part, std::size_t most) const;
    void gather(BadFacetQueue& bad_facets);

    RestrictedDelaunay& restricted_;
    const FacetCriteria& criteria_;
    const Workers& workers_;
    MeshingStatistics& statistics_;
    std::vector<std::unique_ptr<Part>> parts_;
    std::size_t axis_ = 0;       //!< that the next cuts are across
    std::size_t next_round_ = 0; //!< vertices that the mesh has then, at least
};

} // namespace voroprobe
