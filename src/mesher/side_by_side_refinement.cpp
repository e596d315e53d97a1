#include "mesher/side_by_side_refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace voroprobe
{
namespace
{

// With more cuts more conflict zones reach over one: as many subdomains as there is work for, whatever the
// number of threads.
constexpr std::size_t kBadFacetsPerSubdomain = 8192;
constexpr std::size_t kLeastSubdomains = 2;
constexpr std::size_t kMostSubdomains = 16;

// A mesh with fewer vertices is too coarse: most conflict zones reach over any cut.
constexpr std::size_t kLeastVertices = 4000;

// Fewer bad facets are not worth a round.
constexpr std::size_t kLeastBadFacets = 100;

// Insertions of one subdomain in one round: cuts that share the work out evenly do so for a while.
constexpr std::size_t kLeastInsertions = 512;
constexpr std::size_t kMostInsertions = 4096;
constexpr std::size_t kBadFacetsPerInsertion = 2;

// Cuts are made between this many of the bad facets.
constexpr std::size_t kSample = 1024;

std::size_t count_subdomains(const BadFacetQueue& bad_facets)
{
    return std::clamp(bad_facets.size() / kBadFacetsPerSubdomain, kLeastSubdomains, kMostSubdomains);
}

} // namespace

SideBySideRefinement::SideBySideRefinement(RestrictedDelaunay& restricted, const FacetCriteria& criteria,
                                           const Workers& workers, MeshingStatistics& statistics)
    : restricted_(restricted), criteria_(criteria), workers_(workers), statistics_(statistics),
      next_round_(kLeastVertices)
{
}

bool SideBySideRefinement::pays(const BadFacetQueue& bad_facets) const
{
    return bad_facets.size() >= kLeastBadFacets && restricted_.vertex_count() >= next_round_;
}

std::size_t SideBySideRefinement::most_insertions(const BadFacetQueue& bad_facets)
{
    const std::size_t subdomains = count_subdomains(bad_facets);
    return subdomains * std::clamp(bad_facets.size() / subdomains / kBadFacetsPerInsertion, kLeastInsertions,
                                   kMostInsertions);
}

void SideBySideRefinement::refine(BadFacetQueue& bad_facets)
{
    set_part_count(count_subdomains(bad_facets));
    const std::size_t most = most_insertions(bad_facets) / parts_.size();
    cut(bad_facets);
    share_out(bad_facets);
    std::vector<InsertionWorkspace*> workspaces;
    for (const auto& part : parts_)
        workspaces.push_back(&part->workspace);
    restricted_.begin_round(workspaces, most);
    workers_.for_each(
        parts_.size(), [&](std::size_t i) { refine(*parts_[i], most); }, 1);
    restricted_.end_round(workspaces, workers_);
    gather(bad_facets);
    axis_ = (axis_ + 1) % 3;
}

// Across the axis, with as many bad facets between two cuts as between any two.
void SideBySideRefinement::cut(const BadFacetQueue& bad_facets)
{
    std::vector<double> places;
    const std::size_t step = bad_facets.size() / kSample + 1;
    std::size_t place = 0;
    bad_facets.visit(
        [&](const BadFacetQueue::Entry& entry, Badness)
        {
            const RestrictedFacet& facet = restricted_.facet(entry.id);
            if (place++ % step == 0 && facet.generation == entry.generation)
                places.push_back(facet.center[axis_]);
        });
    std::sort(places.begin(), places.end());
    double low = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < parts_.size(); ++i)
    {
        const std::size_t next = (i + 1) * places.size() / parts_.size();
        const double high = next < places.size() ? places[next] : std::numeric_limits<double>::infinity();
        parts_[i]->subdomain = {axis_, low, high};
        low = high;
    }
}

// A facet whose surface Delaunay ball lies in a subdomain has its vertices there. The others wait.
void SideBySideRefinement::share_out(BadFacetQueue& bad_facets)
{
    BadFacetQueue all;
    std::swap(all, bad_facets);
    all.visit(
        [&](const BadFacetQueue::Entry& entry, Badness badness)
        {
            const RestrictedFacet& facet = restricted_.facet(entry.id);
            if (facet.generation != entry.generation)
            {
                ++statistics_.stale_queue_entries;
                return;
            }
            const double radius = std::sqrt(facet.squared_radius);
            const auto within =
                std::find_if(parts_.begin(), parts_.end(),
                             [&](const auto& part) { return part->subdomain.holds(facet.center, radius); });
            BadFacetQueue& queue = within == parts_.end() ? bad_facets : (*within)->bad_facets;
            queue.push(entry.id, entry.generation, badness);
        });
}

void SideBySideRefinement::refine(Part& part, std::size_t most) const
{
    for (part.insertions = 0; part.insertions < most;)
    {
        const auto next = part.bad_facets.pop(restricted_, part.stale_queue_entries);
        if (!next)
            return;
        const auto& [entry, badness] = *next;
        RestrictedFacet& facet = restricted_.facet(entry.id);
        const DelaunayCell start = restricted_.conflicting_cell(facet);
        if (start == DelaunayCell())
        {
            facet.kept = true;
            continue;
        }
        if (!restricted_.prepare(facet.center, start, part.subdomain, part.insertion))
        {
            part.waiting.push(entry.id, entry.generation, badness);
            continue;
        }
        if (!RestrictedDelaunay::has_enough(part.workspace, part.insertion))
        {
            part.bad_facets.push(entry.id, entry.generation, badness);
            return;
        }
        restricted_.insert(part.insertion, VertexOrigin::kRefinement, part.workspace);
        ++part.insertions;
        for (const FacetId id : part.workspace.changed_facets)
        {
            if (const auto next_badness = criteria_.badness(restricted_, id))
                part.bad_facets.push(id, restricted_.facet(id).generation, *next_badness);
        }
    }
}

// Where little was done, the bad facets are near cuts or their Delaunay cells reach far: those are best
// refined one after the other, for a while.
void SideBySideRefinement::gather(BadFacetQueue& bad_facets)
{
    const auto put_back = [&](const BadFacetQueue::Entry& entry, Badness badness)
    { bad_facets.push(entry.id, entry.generation, badness); };
    std::size_t insertions = 0;
    for (const auto& part : parts_)
    {
        part->waiting.visit(put_back);
        part->bad_facets.visit(put_back);
        part->waiting = {};
        part->bad_facets = {};
        insertions += part->insertions;
        statistics_.stale_queue_entries += std::exchange(part->stale_queue_entries, 0);
    }
    statistics_.insertions_side_by_side += insertions;
    if (insertions < kLeastBadFacets)
        next_round_ = restricted_.vertex_count() + kLeastBadFacets / 2;
}

void SideBySideRefinement::set_part_count(std::size_t count)
{
    while (parts_.size() < count)
        parts_.push_back(std::make_unique<Part>());
    for (; parts_.size() > count; parts_.pop_back())
        restricted_.take_back(parts_.back()->workspace);
}

} // namespace voroprobe
