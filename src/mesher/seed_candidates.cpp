#include "mesher/seed_candidates.h"

#include "mesher/nearby_facets.h"

namespace voroprobe
{

SeedCandidates::SeedCandidates(const RestrictedDelaunay& restricted, const MeshingOptions& options,
                               Refinement& refinement, MeshingStatistics& statistics)
    : restricted_(restricted), options_(options), refinement_(refinement), statistics_(statistics),
      separation_(restricted.oracle().domain().diagonal())
{
}

void SeedCandidates::add(const std::vector<Point3>& points)
{
    waiting_.insert(waiting_.end(), points.begin(), points.end());
}

bool SeedCandidates::insert_some()
{
    pass_over_meshed();
    for (; !waiting_.empty() && separation_ > options_.floor_radius; separation_ *= 0.5)
    {
        const std::size_t inserted =
            std::erase_if(waiting_,
                          [&](const Point3& p)
                          {
                              return restricted_.is_apart(p, separation_) &&
                                     refinement_.insert(p, VertexOrigin::kProbe) != VertexHandle();
                          });
        if (inserted > 0)
            return true;
    }
    statistics_.seeds_passed_over += waiting_.size(); // within the floor of others
    waiting_.clear();
    return false;
}

void SeedCandidates::pass_over_meshed()
{
    statistics_.seeds_passed_over += std::erase_if(
        waiting_, [&](const Point3& p) { return is_meshed(restricted_, p, options_.reach_lower_bound); });
}

} // namespace voroprobe
