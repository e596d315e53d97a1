#include "mesher/inventory_pursuit.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "mesher/faithfulness.h"
#include "oracles/coverage.h"

namespace voroprobe
{
namespace
{

// A surface without facets gets 32 points, then four times as many in each round: more than 32,768, in the
// last of six, no speck has crossings with the grid.
constexpr std::size_t kFirstSeeds = 32;
constexpr int kInventoryRounds = 6;
constexpr int kInventoryFloorRounds = 2; // that lower the floor: what is left is for labels to put right

// Spacings are halved in each round, from the floor to an eighth of it, which is the smallest local floor.
constexpr int kFlawRounds = 4;
constexpr int kNeckRounds = 2; // of points at necks: what is left gets coarse handles

// A part that needs points closer than this is thinner than the floor can resolve.
constexpr double kLeastSpacingInFloors = 2.0;

std::size_t seeds_of_round(int round)
{
    return kFirstSeeds << (2 * (round - 1));
}

void append(std::vector<Point3>& points, const std::vector<Point3>& more)
{
    points.insert(points.end(), more.begin(), more.end());
}

} // namespace

bool InventoryPursuit::is_wanted() const
{
    return restricted_.oracle().surface_count() > 0 &&
           (options_.seeding == Seeding::kInventory || options_.seeding == Seeding::kProbe);
}

bool InventoryPursuit::insert_into_missing_surfaces()
{
    const int round = ++inventory_round_;
    if (!is_wanted() || round > kInventoryRounds)
        return false;
    const std::vector<SurfaceId> missing = find_missing_surfaces(restricted_);
    const std::size_t seeds =
        seed_surfaces(missing, seeds_of_round(round), round == 1 ? Seeds::kOnGrid : Seeds::kOnRays,
                      restricted_.oracle(), refinement_);
    std::vector<Point3> places = find_unfaithful_places(restricted_);
    if (missing.empty())
        append(places, settlement_.find_gaps());
    // Along a crease of the interpolant there are the more of them the closer one looks.
    const bool helps = round == 1 || places.size() < unfaithful_places_;
    unfaithful_places_ = places.size();
    return (helps && refinement_.lower_floor(places, std::min(round, kInventoryFloorRounds))) || seeds > 0;
}

bool InventoryPursuit::insert_at_flaws()
{
    const int round = ++flaw_round_;
    if (!is_wanted() || round > kFlawRounds || !flaws_yield_)
        return false;
    find_uncovered();
    const double spacing = std::ldexp(options_.floor_radius, 1 - round);
    const bool has_gaps = settlement_.pieces_left_apart() > 0;
    const std::vector<Point3> points = flawed_points(spacing);
    const std::vector<SurfaceId> lost = settlement_.surfaces_without_vertices();
    if (points.empty() && lost.empty() && !has_gaps)
        return false;
    settlement_.unsettle();
    std::vector<Point3> places;
    if (has_gaps)
        places = settlement_.find_gaps();
    const std::size_t seeds =
        seed_surfaces(lost, seeds_of_round(round), Seeds::kOnRays, restricted_.oracle(), refinement_) +
        seed_points(points, spacing, restricted_, refinement_);
    if (round > 1 || seeds == 0)
        append(places, points);
    flaws_yield_ = refinement_.lower_floor(places, round) || seeds > 0;
    return true;
}

//! On parts of surfaces that the mesh does not come to, and around necks.
std::vector<Point3> InventoryPursuit::flawed_points(double spacing) const
{
    std::vector<Point3> points;
    for (const SurfacePoint& at : uncovered_)
        points.push_back(at.point);
    if (flaw_round_ <= kNeckRounds || settlement_.pieces_left_apart() > 0)
        append(points, points_around(settlement_.necks_to_refine(), spacing, restricted_.oracle()));
    return points;
}

//! Looks for parts of surfaces that the mesh does not come to; after the first time, whether it has come to
//! those found last. The thinner a part, the closer the points have to be for facets to connect them: a
//! quarter of the spacing in each round.
void InventoryPursuit::find_uncovered()
{
    const SurfaceOracle& oracle = restricted_.oracle();
    const double radius =
        std::min(2.0 * options_.max_facet_radius, settlement_.longest_side() + options_.reach_lower_bound);
    const double spacing =
        std::max(std::ldexp(radius, 1 - 2 * flaw_round_), kLeastSpacingInFloors * options_.floor_radius);
    const std::span<const SurfacePoint> vertices = settlement_.vertices_on_surfaces();
    uncovered_ = flaw_round_ == 1 ? find_uncovered_points(oracle, vertices, radius, spacing, options_.threads)
                                  : find_uncovered_points_near(std::move(uncovered_), oracle, vertices,
                                                               radius, spacing, options_.threads);
    statistics_.uncovered_points += uncovered_.size();
}

} // namespace voroprobe
