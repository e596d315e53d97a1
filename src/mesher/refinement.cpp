#include "mesher/refinement.h"

#include <limits>

#include "mesher/umbrella.h"

namespace voroprobe
{
namespace
{

constexpr std::size_t kInsertionsBetweenReports = 1024;

} // namespace

Refinement::Refinement(RestrictedDelaunay& restricted, const MeshingOptions& options, const Workers& workers,
                       MeshingStatistics& statistics, ProgressSink* progress)
    : restricted_(restricted), workers_(workers), statistics_(statistics), progress_(progress),
      criteria_(options), side_by_side_(restricted, criteria_, workers, statistics),
      max_vertices_(options.max_vertices.value_or(std::numeric_limits<std::size_t>::max()))
{
}

VertexHandle Refinement::insert(const Point3& p, VertexOrigin origin, VertexHandle hint)
{
    const VertexHandle vertex = restricted_.insert(p, origin, hint);
    judge_changed_facets();
    return vertex;
}

void Refinement::judge_changed_facets()
{
    for (const FacetId id : restricted_.changed_facets())
        judge(id);
}

void Refinement::judge(FacetId id)
{
    if (const auto badness = criteria_.badness(restricted_, id))
        bad_facets_.push(id, restricted_.facet(id).generation, *badness);
}

bool Refinement::lower_floor(std::span<const Point3> places, int round)
{
    bool changed = false;
    for (const Point3& place : places)
        changed = criteria_.floor().lower(place, round) || changed;
    if (!changed)
        return false;
    for (FacetId id = 0; id < restricted_.facet_slots(); ++id)
    {
        const RestrictedFacet& facet = restricted_.facet(id);
        if (facet.crossing_count == 0 || facet.kept ||
            facet.squared_radius > criteria_.floor().squared_base() || criteria_.at_floor(facet))
            continue;
        judge(id);
        for (int i = 0; i < 4; ++i) // for their umbrellas
        {
            if (facet.odd() && i != facet.index)
                restricted_.mark_unchecked(facet.delaunay_cell->vertex(i));
        }
    }
    return true;
}

void Refinement::refine()
{
    while (may_go_on())
    {
        if (side_by_side_.pays(bad_facets_) &&
            restricted_.vertex_count() + side_by_side_.most_insertions(bad_facets_) <= max_vertices_)
            side_by_side_.refine(bad_facets_);
        else if (const auto bad_facet = bad_facets_.pop(restricted_, statistics_.stale_queue_entries))
        {
            if (restricted_.vertex_count() >= max_vertices_)
                status_ = MeshingStatus::kBudgetExhausted; // there was more to do
            else
                refine_facet(bad_facet->first.id);
        }
        else if (!find_unresolved_facets() && !find_pinched_vertices())
            break;
    }
    side_by_side_.finish();
}

// Inserts the center of the facet's surface Delaunay ball. Where rounding hides the conflict the facet is
// kept as it is.
void Refinement::refine_facet(FacetId id)
{
    RestrictedFacet& facet = restricted_.facet(id);
    const DelaunayCell start = restricted_.conflicting_cell(facet);
    if (start == DelaunayCell())
    {
        facet.kept = true;
        return;
    }
    restricted_.prepare(facet.center, start, insertion_);
    restricted_.insert(insertion_, VertexOrigin::kRefinement);
    judge_changed_facets();
}

// Adds the facets whose two cells lie on one side of the surface although their dual edge meets it; false
// where there is none.
bool Refinement::find_unresolved_facets()
{
    restricted_.query_even_facets(workers_);
    judge_changed_facets();
    return !restricted_.changed_facets().empty();
}

// Adds the facets that break the manifold criterion to the queue; false where there is none.
bool Refinement::find_pinched_vertices()
{
    const UmbrellaFindings findings = check_umbrellas(restricted_, criteria_, workers_);
    isolated_vertices_.insert(isolated_vertices_.end(), findings.isolated_vertices.begin(),
                              findings.isolated_vertices.end());
    for (const FacetId id : findings.bad_facets)
        bad_facets_.push(id, restricted_.facet(id).generation, Badness::kPinched);
    return !findings.bad_facets.empty();
}

std::optional<VertexHandle> Refinement::take_isolated_vertex()
{
    while (!isolated_vertices_.empty())
    {
        const VertexHandle vertex = isolated_vertices_.back();
        isolated_vertices_.pop_back();
        restricted_.odd_facets_around(vertex, facets_);
        if (facets_.empty())
            return vertex;
    }
    return std::nullopt;
}

bool Refinement::may_go_on()
{
    if (status_ != MeshingStatus::kDone)
        return false;
    if (progress_ != nullptr && statistics_.insertions >= next_report_)
    {
        next_report_ = statistics_.insertions + kInsertionsBetweenReports;
        progress_->report({"refinement", restricted_.vertex_count(), bad_facets_.size()});
        if (progress_->stop_requested())
            status_ = MeshingStatus::kInterrupted;
    }
    return status_ == MeshingStatus::kDone;
}

} // namespace voroprobe
