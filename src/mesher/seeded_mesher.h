#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "mesher/meshing_options.h"
#include "oracles/surface_oracle.h"
#include "support/progress.h"

namespace voroprobe
{

//! How a meshing run ended.
enum class MeshingStatus
{
    kDone,
    kInterrupted,    //!< the progress sink asked to stop
    kBudgetExhausted //!< `max_vertices` or `max_seconds` reached
};

//! Work done and exceptions made, by purpose. Counts compare across machines, seconds do not.
struct MeshingStatistics
{
    std::size_t queries_probing = 0;        //!< oracle segment queries by probe()
    std::size_t probe_hits = 0;             //!< crossings found by probing Voronoi cells and inserted
    std::size_t probe_hits_passed_over = 0; //!< crossings met by probe() nearer to the mesh than the reach
    std::size_t cells_probed = 0;           //!< Voronoi cells that came up in the queue, as often as they did
    //! Voronoi cells that took few probes or none and were never in the queue.
    std::size_t cells_probed_at_once = 0;
    std::size_t queries_initialization = 0;  //!< by initialize_component()
    std::size_t queries_refinement = 0;      //!< about dual edges, whoever inserted the point
    std::size_t region_lookups = 0;          //!< oracle point queries
    std::size_t insertions = 0;              //!< points inserted into the triangulation
    std::size_t insertions_side_by_side = 0; //!< of these in subdomains, by threads where there are several
    std::size_t stale_queue_entries = 0;     //!< bad facets popped after they had vanished

    std::size_t components_by_initialization = 0;  //!< pieces first met by probe(domain)
    std::size_t components_by_isolated_vertex = 0; //!< pieces begun at an isolated vertex
    std::size_t components_by_probing = 0;         //!< pieces first met by probing a Voronoi cell
    std::size_t components_by_inventory = 0;       //!< pieces given points because the inventory lists them
    std::size_t components_by_refinement = 0;      //!< pieces that refinement reached by itself
    std::size_t seeds_off_surface = 0;             //!< seeds given farther from the surface than the reach
    std::size_t seeds_passed_over = 0;             //!< seeds that the mesh came to before they were needed
    std::size_t isolated_vertices_abandoned = 0;   //!< points of the surface on no face in the end

    //! Facets whose dual edge crosses the surface more than once in the end: as small as the floor, unless
    //! the run was stopped.
    std::size_t facets_at_floor = 0;
    //! Points where the mesh had not come to a part of a surface and was sent to (coverage.h).
    std::size_t uncovered_points = 0;
    //! What repair_regions() did where refinement ended at the floor: Delaunay cells moved to another region,
    //! pieces of regions dissolved where the region is not, and pieces of one region joined.
    std::size_t cells_reconciled = 0;
    std::size_t crumbs_dissolved = 0;
    std::size_t necks_bridged = 0;
    //! Bridges and tunnels opened or closed by labels alone, to have as many handles as the scan.
    std::size_t handles_mended = 0;
    //! Slivers moved to the other side of the surface to mend a pinched edge, and crumbs dissolved.
    std::size_t cells_relabelled = 0;
    //! Vertices moved by a hair where the surface touched itself.
    std::size_t contacts_separated = 0;
    //! Contacts that could not be taken apart: the inside around them was given up.
    std::size_t contacts_carved = 0;

    double seconds_probing = 0.0;    //!< wall clock of probing, part of seconds_refinement
    double seconds_refinement = 0.0; //!< wall clock of the whole run: seeding, refinement, extraction
};

//! By which means a piece of the mesh was found; where several apply the last one counts.
enum class FoundBy : std::uint8_t
{
    kRefinement,
    kIsolatedVertex,
    kInventory,
    kCellProbe,
    kProbe
};

struct FoundPiece
{
    SurfaceId surface; //!< of the oracle's inventory; 0 where there is none
    FoundBy found_by;
};

struct MeshingResult
{
    TriangleMesh mesh; //!< oracle frame; closed (but for an open border), oriented outward, 2-manifold, no
                       //!< face crossing another

    //! Of each face the surface of the oracle's inventory it lies on; 0 throughout where there is none.
    std::vector<SurfaceId> surface_of_face;

    //! The pieces that the statistics count, in no particular order.
    std::vector<FoundPiece> pieces;
    MeshingStatistics statistics;
    MeshingStatus status = MeshingStatus::kDone;
};

//! Meshes the surface of `oracle` by Delaunay refinement that seeds itself.
//! Source: Feree & Alliez, Probing for Surface Mesh Generation through Delaunay Refinement, RR-8123, 2009.
//! An oracle that crosses no probe gives an empty mesh. Cost: O(n log n) for n vertices, plus the probes.
//! \throw UsageError where an option is outside its range.
MeshingResult mesh_surface(const SurfaceOracle& oracle, const MeshingOptions& options,
                           ProgressSink* progress = nullptr);

//! Sets `components_by_...` to the numbers of these pieces.
void count_found_pieces(std::span<const FoundPiece> pieces, MeshingStatistics& statistics);

} // namespace voroprobe
