// This file follows:
// Hugo Feree and Pierre Alliez, Probing for Surface Mesh Generation through Delaunay Refinement, INRIA
// RR-8123, 2009, Sec. 4.

#include "mesher/seeded_mesher.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "mesher/cell_probing.h"
#include "mesher/deadline.h"
#include "mesher/faithfulness.h"
#include "mesher/initialization.h"
#include "mesher/refinement.h"
#include "mesher/region_repair.h"
#include "mesher/region_settlement.h"
#include "mesher/restricted_delaunay.h"
#include "mesher/seed_candidates.h"
#include "mesher/seeding.h"
#include "mesher/surface_extraction.h"
#include "oracles/coverage.h"
#include "support/error.h"
#include "support/number_text.h"
#include "support/stopwatch.h"
#include "support/workers.h"

namespace voroprobe
{
namespace
{

// Points given to a surface without facets, the first time; four times as many each time after.
constexpr std::size_t kSeedsPerSurface = 8;
constexpr int kInventoryRounds = 6;
constexpr int kInventoryFloorRounds = 2; // that lower the floor
// Of points at necks, and of those in gaps and on parts of surfaces that the mesh does not come to.
constexpr int kNeckRounds = 2;
constexpr int kFlawRounds = 4;
constexpr double kLeastSpacingInFloors = 2.0;

class SeededMesher
{
public:
    SeededMesher(const SurfaceOracle& oracle, const MeshingOptions& options, ProgressSink* progress)
        : oracle_(oracle), options_(options), workers_(options.threads), restricted_(oracle, statistics_),
          deadline_(progress, options.max_seconds),
          refinement_(restricted_, options_, workers_, statistics_, &deadline_),
          seed_candidates_(restricted_, options_, refinement_, statistics_),
          cell_probing_(restricted_, options_, workers_, statistics_, deadline_),
          settlement_(restricted_, options_, workers_)
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
        for (int round = 1; may_go_on() && pursue_inventory(round); ++round)
            refinement_.refine();
        settlement_.settle(may_go_on());
        for (int round = 1; may_go_on() && pursue_flaws(round); ++round)
            settlement_.settle(may_go_on());
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

    [[nodiscard]] bool may_pursue_inventory() const
    {
        return oracle_.surface_count() > 0 &&
               (options_.seeding == Seeding::kInventory || options_.seeding == Seeding::kProbe);
    }

    //! Gives points to the surfaces of the inventory without facets, and lowers the floor where facets do not
    //! lie on one surface or a region is in pieces. False when there is nothing left to pursue.
    bool pursue_inventory(int round)
    {
        if (!may_pursue_inventory() || round > kInventoryRounds)
            return false;
        const std::vector<SurfaceId> missing = find_missing_surfaces(restricted_);
        const std::size_t seeds =
            seed_surfaces(missing, kSeedsPerSurface << (2 * round),
                          round == 1 ? Seeds::kOnGrid : Seeds::kOnRays, oracle_, refinement_);
        std::vector<Point3> places = find_unfaithful_places(restricted_);
        if (missing.empty())
        {
            const std::vector<Point3> gaps = settlement_.find_gaps();
            places.insert(places.end(), gaps.begin(), gaps.end());
        }
        // Along a crease of the interpolant there are the more of them the closer one looks.
        const bool helps = round == 1 || places.size() < unfaithful_places_;
        unfaithful_places_ = places.size();
        return (helps && refinement_.lower_floor(places, std::min(round, kInventoryFloorRounds))) ||
               seeds > 0;
    }

    //! Gives points to surfaces that refinement has lost again, to parts of surfaces that the mesh does not
    //! come to, and to the necks of the scan that labels alone could not put right, half as far apart in each
    //! round: a region as thin as a hair holds together where its two sides have points as close. Lowers the
    //! floor there, if that is not the first time, and where a region is in pieces; and refines. False where
    //! there is no such place; else the regions are unsettled.
    bool pursue_flaws(int round)
    {
        if (!may_pursue_inventory() || round > kFlawRounds || !flaws_yield_)
            return false;
        find_uncovered(round);
        std::vector<Point3> points;
        for (const SurfacePoint& at : uncovered_)
            points.push_back(at.point);
        const double spacing = std::ldexp(options_.floor_radius, 1 - round);
        const bool has_gaps = settlement_.pieces_left_apart() > 0;
        if (round <= kNeckRounds || has_gaps)
        {
            const std::vector<Point3> at_necks =
                points_around(settlement_.necks_to_refine(), spacing, oracle_);
            points.insert(points.end(), at_necks.begin(), at_necks.end());
        }
        const std::vector<SurfaceId> lost = settlement_.surfaces_without_vertices();
        if (points.empty() && lost.empty() && !has_gaps)
            return false;
        settlement_.unsettle();
        std::vector<Point3> places;
        if (has_gaps)
            places = settlement_.find_gaps();
        const std::size_t seeds =
            seed_surfaces(lost, kSeedsPerSurface << (2 * round), Seeds::kOnRays, oracle_, refinement_) +
            seed_points(points, spacing, restricted_, refinement_);
        if (round > 1 || seeds == 0)
            places.insert(places.end(), points.begin(), points.end());
        flaws_yield_ = refinement_.lower_floor(places, round) || seeds > 0;
        refinement_.refine();
        return true;
    }

    //! Looks for parts of surfaces that the mesh does not come to; after the first time, whether it has come
    //! to those found last. The thinner a part, the closer the points have to be for facets to connect them:
    //! a quarter of the spacing in each round.
    void find_uncovered(int round)
    {
        const double radius = options_.max_facet_radius;
        const double spacing =
            std::max(std::ldexp(radius, 2 - 2 * round), kLeastSpacingInFloors * options_.floor_radius);
        const std::span<const SurfacePoint> vertices = settlement_.vertices_on_surfaces();
        uncovered_ = round == 1
                         ? find_uncovered_points(oracle_, vertices, 2.0 * radius, spacing, options_.threads)
                         : find_uncovered_points_near(std::move(uncovered_), oracle_, vertices, 2.0 * radius,
                                                      spacing, options_.threads);
        statistics_.uncovered_points += uncovered_.size();
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
    std::vector<SurfacePoint> uncovered_; //!< points that the mesh did not come to when last looked for
    bool flaws_yield_ = true;             //!< something could be done about the last ones
    bool stopped_ = false;                //!< before the work was done
    std::size_t unfaithful_places_ = 0;   //!< when last looked for
};

void require(bool condition, const std::string& name, double value, const std::string& range)
{
    if (!condition)
        throw UsageError(name + " is " + number_text(value) + "; it must be " + range);
}

void check_options(const MeshingOptions& options)
{
    const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
    require(positive(options.max_facet_radius), "max_facet_radius", options.max_facet_radius,
            "finite and above 0");
    require(positive(options.floor_radius), "floor_radius", options.floor_radius, "finite and above 0");
    require(positive(options.reach_lower_bound), "reach_lower_bound", options.reach_lower_bound,
            "finite and above 0");
    require(options.min_facet_angle_deg >= 0.0 && options.min_facet_angle_deg <= 30.0, "min_facet_angle_deg",
            options.min_facet_angle_deg, "in [0, 30] degrees");
    const double component_radius = options.component_radius.value_or(options.reach_lower_bound);
    require(component_radius >= options.reach_lower_bound && std::isfinite(component_radius),
            "component_radius", component_radius, "finite and at least reach_lower_bound");
    require(!options.max_seconds || *options.max_seconds >= 0.0, "max_seconds",
            options.max_seconds.value_or(0.0), "at least 0");
    if (options.domain_ball)
        require(positive(options.domain_ball->radius) && is_finite(options.domain_ball->center),
                "the radius of domain_ball", options.domain_ball->radius, "finite and above 0");
    if (options.max_facet_distance)
        require(positive(*options.max_facet_distance), "max_facet_distance", *options.max_facet_distance,
                "finite and above 0");
}

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
