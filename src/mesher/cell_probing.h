#pragma once

#include <optional>
#include <vector>

#include "mesher/meshing_options.h"
#include "mesher/nearby_facets.h"
#include "mesher/probe_queue.h"
#include "mesher/probing.h"
#include "mesher/restricted_delaunay.h"
#include "mesher/seeded_mesher.h"
#include "mesher/slab_probing.h"
#include "mesher/voronoi_cell.h"
#include "support/progress.h"
#include "support/workers.h"

namespace voroprobe
{

//! A crossing found by probing that is news.
struct ProbeHit
{
    Point3 point;
    VertexHandle near; //!< the vertex whose Voronoi cell was probed; null for the domain
};

//! The probing of Voronoi cells, with the queue Q of those that were not probed yet.
//!
//! A crossing is passed over where it is nearer than the reach to the mesh as the surface's stand-in: to a
//! vertex, or to an odd facet that lies itself within the reach of the surface (center of its surface
//! Delaunay ball to its circumcenter). The paper's criteria are so strong that every facet is; with coarser
//! ones a facet can stray to where another component may be, and must not hide that. What is passed over then
//! lies within 2 reaches of a meshed component, as the proof of Proposition 4 wants it.
//!
//! What is not passed over is at least the reach away from every vertex: the cells of the points inserted
//! exclude each other's halves, so probing ends after at most 6 volume(domain) / (pi reach^3) hits or so
//! whatever the criteria.
class CellProbing
{
public:
    //! All references must outlive the object. `stop` can end probing early.
    CellProbing(RestrictedDelaunay& restricted, const MeshingOptions& options, const Workers& workers,
                MeshingStatistics& statistics, const ProgressSink& stop);
    CellProbing(const CellProbing&) = delete; // is_news_ knows where it lives
    CellProbing& operator=(const CellProbing&) = delete;

    //! probe(Omega).
    std::optional<ProbeHit> probe_domain();

    //! Pops Q and probes until a crossing is news; nullopt when Q is empty, or when stopped.
    std::optional<ProbeHit> probe_cells_until_hit();

    //! Whether probing was asked to stop while cells were left.
    [[nodiscard]] bool was_stopped() const { return probing_.was_stopped(); }

private:
    void collect_unprobed_cells();
    void probe_by_few(const std::vector<VertexHandle>& vertices, std::size_t begin, std::size_t end);
    std::optional<Point3> probe_slabs(const IsNews& is_news);
    void update_statistics();
    std::optional<Point3> probe_cell(VertexHandle vertex);
    [[nodiscard]] bool is_news(const Point3& crossing);

    RestrictedDelaunay& restricted_;
    MeshingOptions options_;
    const Workers& workers_;
    MeshingStatistics& statistics_;
    ProbedDomain domain_;
    double probe_radius_; //!< every point is within this of a probe
    ProbeCounts counts_;
    Probing probing_;
    ProbeQueue unprobed_cells_;
    VoronoiCell voronoi_cell_;
    ConvexRegion region_;
    ConvexOutline outline_;
    SlabProbing slab_probing_;
    MeshAroundVertex mesh_; //!< around the vertex of voronoi_cell_
    FacetCorners facets_in_zone_;
    std::vector<DelaunayCell> zone_;
    IsNews is_news_; //!< of crossings in voronoi_cell_
};

} // namespace voroprobe
