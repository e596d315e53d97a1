// This file follows:
// Hugo Feree and Pierre Alliez, Probing for Surface Mesh Generation through Delaunay Refinement, INRIA
// RR-8123, 2009, Sec. 4.

#include "mesher/seeded_mesher.h"

#include <cmath>
#include <string>

#include "mesher/initialization.h"
#include "mesher/probing.h"
#include "mesher/refinement.h"
#include "mesher/restricted_delaunay.h"
#include "mesher/surface_extraction.h"
#include "support/error.h"
#include "support/stopwatch.h"

namespace voroprobe
{
namespace
{

// Points of initialize_component() nearer than this to a vertex, in floor radii, would only make slivers.
constexpr double kLeastSeparationInFloors = 1.0 / 64.0;

class SeededMesher
{
public:
    SeededMesher(const SurfaceOracle& oracle, const MeshingOptions& options, ProgressSink* progress)
        : oracle_(oracle), options_(options), progress_(progress), restricted_(oracle, statistics_),
          refinement_(restricted_, options_, statistics_, progress)
    {
    }

    MeshingResult run()
    {
        const auto first = probe_domain(oracle_, options_.reach_lower_bound, statistics_.queries_probing);
        if (!first)
            return result();

        initialize(refinement_.insert(*first, VertexOrigin::kProbe));
        do
            refinement_.refine();
        while (refinement_.status() == MeshingStatus::kDone && initialize_isolated_vertices());
        return result();
    }

private:
    void initialize(VertexHandle vertex)
    {
        initialize_component(vertex, restricted_, options_, refinement_, statistics_);
    }

    //! False when there is no isolated vertex left that has attempts left.
    bool initialize_isolated_vertices()
    {
        bool any = false;
        while (const auto isolated = refinement_.take_isolated_vertex())
        {
            if ((*isolated)->info().initializations == kMaxInitializations)
            {
                ++statistics_.isolated_vertices_abandoned;
                continue;
            }
            initialize(*isolated);
            any = true;
            if (options_.isolated_vertices == IsolatedVertices::kOneAtATime)
                break;
        }
        return any;
    }

    MeshingResult result()
    {
        MeshingResult result;
        result.mesh = extract_surface(restricted_, options_, statistics_);
        statistics_.seconds_refinement = stopwatch_.seconds();
        result.statistics = statistics_;
        result.status = refinement_.status();
        return result;
    }

    const SurfaceOracle& oracle_;
    MeshingOptions options_;
    ProgressSink* progress_;
    MeshingStatistics statistics_;
    Stopwatch stopwatch_;
    RestrictedDelaunay restricted_;
    Refinement refinement_;
};

void require(bool condition, const std::string& name, double value, const std::string& range)
{
    if (!condition)
        throw UsageError(name + " is " + std::to_string(value) + "; it must be " + range);
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
    if (options.max_facet_distance)
        require(positive(*options.max_facet_distance), "max_facet_distance", *options.max_facet_distance,
                "finite and above 0");
}

} // namespace

MeshingResult mesh_surface(const SurfaceOracle& oracle, const MeshingOptions& options, ProgressSink* progress)
{
    check_options(options);
    return SeededMesher(oracle, options, progress).run();
}

} // namespace voroprobe
