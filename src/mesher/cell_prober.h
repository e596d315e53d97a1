#pragma once

#include "mesher/convex_outline.h"
#include "mesher/nearby_facets.h"
#include "mesher/probing.h"
#include "mesher/restricted_delaunay.h"
#include "mesher/slab_probing.h"
#include "mesher/voronoi_cell.h"

namespace voroprobe
{

//! Probes Voronoi cells as far as that is quick. Writes nothing to the triangulation: several threads may
//! have one each, and use them side by side while nothing is inserted.
class CellProber
{
public:
    //! All references must outlive the object. `probe_radius`: every point of a cell is to be within this of
    //! a probe; `reach`: crossings this near to the mesh are passed over.
    CellProber(const RestrictedDelaunay& restricted, const ProbedDomain& domain, double probe_radius,
               double reach);
    CellProber(const CellProber&) = delete; // is_news_ knows where it lives
    CellProber& operator=(const CellProber&) = delete;

    //! Whether the cell of a vertex, no sentinel, is probed now, by few probes whose crossings the mesh
    //! around the vertex explains. Where it is not, probe_cells_until_hit() has to.
    bool probe_by_few(VertexHandle vertex);

    //! Whether every point of the cell is near one of its edges: refinement has asked about all Voronoi
    //! edges. See SlabProbing for the proof.
    bool is_probed_by_its_edges(VertexHandle vertex);

    //! Of the vertex asked about last: see VoronoiCell::size_within().
    [[nodiscard]] double size() const { return cell_.size_within(domain_.box); }

    //! Of all cells so far.
    [[nodiscard]] const ProbeCounts& counts() const { return counts_; }

private:
    //! Few probes are few enough not to look for whether to stop.
    class NeverStops final : public ProgressSink
    {
    public:
        void report(const ProgressReport& /*report*/) override {}
        [[nodiscard]] bool stop_requested() const override { return false; }
    };

    ProbedDomain domain_;
    double probe_radius_;
    NeverStops never_stops_;
    ProbeCounts counts_;
    Probing probing_;
    SlabProbing slab_probing_;
    VoronoiCell cell_;
    ConvexOutline outline_;
    MeshAroundVertex mesh_;
    IsNews is_news_;
};

} // namespace voroprobe
