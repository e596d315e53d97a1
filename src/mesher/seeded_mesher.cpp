// This file follows:
// Hugo Feree and Pierre Alliez, Probing for Surface Mesh Generation through Delaunay Refinement, INRIA
// RR-8123, 2009, Sec. 4.

#include "mesher/seeded_mesher.h"

#include <optional>
#include <utility>
#include <vector>

#include "mesher/cell_probing.h"
#include "mesher/deadline.h"
#include "mesher/initialization.h"
#include "mesher/inventory_pursuit.h"
#include "mesher/refinement.h"
#include "mesher/region_settlement.h"
#include "mesher/restricted_delaunay.h"
#include "mesher/seed_candidates.h"
#include "mesher/seeding.h"
#include "mesher/surface_extraction.h"
#include "support/error.h"
#include "support/stopwatch.h"
#include "support/workers.h"

namespace voroprobe
{
namespace
{

class SeededMesher
{
public:
    SeededMesher(const SurfaceOracle& oracle, const MeshingOptions& options, ProgressSink* progress)
        : oracle_(oracle), options_(options), workers_(options.threads), restricted_(oracle, statistics_),
          deadline_(progress, options.max_seconds),
          refinement_(restricted_, options_, workers_, statistics_, &deadline_),
          seed_candidates_(restricted_, options_, refinement_, statistics_),
          cell_probing_(restricted_, options_, workers_, statistics_, deadline_),
          settlement_(restricted_, options_, workers_),
          pursuit_(restricted_, options_, refinement_, settlement_, statistics_)
    {
    }

    MeshingResult run()
    {
        find_seeds();
        if (insert_seeds() || probe_domain())
        {
            do
                refinement_.refine();
            while (may_go_on() &&
                   (initialize_isolated_vertices() || insert_seeds() || probe_cells_until_hit()));
        }
        while (may_go_on() && pursuit_.insert_into_missing_surfaces())
            refinement_.refine();
        settlement_.settle(may_go_on());
        while (may_go_on() && pursuit_.insert_at_flaws())
        {
            refinement_.refine();
            settlement_.settle(may_go_on());
        }
        settlement_.finish();
        ExtractedSurface extracted = extract_surface(restricted_, settlement_, options_, statistics_);
        stopped_ =
            stopped_ || refinement_.status() == MeshingStatus::kInterrupted || cell_probing_.was_stopped();
        return result(std::move(extracted));
    }

private:
    //! Whether nothing has stopped the run; remembers it if something has.
    bool may_go_on()
    {
        stopped_ = stopped_ || cell_probing_.was_stopped() || deadline_.stop_requested();
        return refinement_.status() == MeshingStatus::kDone && !stopped_;
    }

    //! The points to begin with that are given, or random.
    void find_seeds()
    {
        std::size_t& queries = statistics_.queries_initialization;
        std::vector<Point3> points;
        if (options_.seeding == Seeding::kRandom)
            points = random_surface_points(oracle_, options_.random_points, options_.random_seed, queries);
        for (const Point3& seed : options_.seeds)
        {
            if (const auto snapped = snap_to_surface(oracle_, seed, options_.reach_lower_bound, queries))
                points.push_back(*snapped);
            else
                ++statistics_.seeds_off_surface;
        }
        seed_candidates_.add(points);
    }

    //! False when there are none that the mesh needs.
    bool insert_seeds() { return seed_candidates_.insert_some(); }

    //! Whether the user knows that there is nothing left to find.
    [[nodiscard]] bool has_all_components() const
    {
        return options_.component_count && count_pieces(restricted_) >= *options_.component_count;
    }

    //! P0 = probe(Omega), initialize_component(P0). False when there is no surface.
    bool probe_domain()
    {
        const auto hit = cell_probing_.probe_domain();
        if (hit)
            initialize(refinement_.insert(hit->point, VertexOrigin::kProbe));
        return hit.has_value();
    }

    //! Pops Q and probes until a crossing is news. The crossing becomes an isolated vertex, as a rule; false
    //! when Q is empty.
    bool probe_cells_until_hit()
    {
        const bool wanted = options_.seeding == Seeding::kProbe ||
                            (options_.seeding == Seeding::kInventory && oracle_.surface_count() == 0);
        if (!wanted || has_all_components())
            return false;
        const Stopwatch stopwatch;
        deadline_.report({"probing", restricted_.vertex_count(), 0});
        const auto hit = cell_probing_.probe_cells_until_hit();
        statistics_.seconds_probing += stopwatch.seconds();
        if (hit)
            refinement_.insert(hit->point, VertexOrigin::kCellProbe, hit->near);
        return hit.has_value();
    }

    //! False where no triangle could be begun at the vertex. Otherwise the vertex is looked at again after
    //! refinement: if it is still isolated, the next attempt is smaller.
    bool initialize(VertexHandle vertex)
    {
        if (!initialize_component(vertex, restricted_, options_, refinement_, statistics_))
            return false;
        restricted_.mark_unchecked(vertex);
        return true;
    }

    //! False when there is no isolated vertex left at which a triangle can be begun.
    bool initialize_isolated_vertices()
    {
        bool any = false;
        if (options_.seeding == Seeding::kRandom)
            return any;
        while (const auto isolated = refinement_.take_isolated_vertex())
        {
            if ((*isolated)->info().initializations == kMaxInitializations || !initialize(*isolated))
                continue; // on no face in the end, unless refinement reaches it: counted then
            any = true;
            if (options_.isolated_vertices == IsolatedVertices::kOneAtATime)
                break;
        }
        return any;
    }

    MeshingResult result(ExtractedSurface extracted)
    {
        MeshingResult result;
        result.mesh = std::move(extracted.mesh);
        result.surface_of_face = std::move(extracted.surface_of_face);
        result.pieces = std::move(extracted.pieces);
        statistics_.seconds_refinement = stopwatch_.seconds();
        result.statistics = statistics_;
        result.status = refinement_.status();
        if (result.status != MeshingStatus::kBudgetExhausted && stopped_)
            result.status =
                deadline_.is_expired() ? MeshingStatus::kBudgetExhausted : MeshingStatus::kInterrupted;
        return result;
    }

    const SurfaceOracle& oracle_;
    MeshingOptions options_;
    MeshingStatistics statistics_;
    Stopwatch stopwatch_;
    Workers workers_;
    RestrictedDelaunay restricted_;
    Deadline deadline_;
    Refinement refinement_;
    SeedCandidates seed_candidates_;
    CellProbing cell_probing_;
    RegionSettlement settlement_;
    InventoryPursuit pursuit_;
    bool stopped_ = false; //!< before the work was done
};

} // namespace

MeshingResult mesh_surface(const SurfaceOracle& oracle, const MeshingOptions& options, ProgressSink* progress)
{
    check_options(options);
    const Box3 domain = oracle.domain();
    if (domain.empty() || !is_finite(domain.min) || !is_finite(domain.max) || domain.diagonal() == 0.0)
        throw UsageError(
            "the oracle's domain is empty, a point or not finite; it must be a box that holds the object");
    return SeededMesher(oracle, options, progress).run();
}

} // namespace voroprobe
