#include "mesher/region_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mesher/cell_shape.h"
#include "mesher/region_components.h"

namespace voroprobe
{
namespace
{

constexpr int kPasses = 8;                       // each looks at what the one before has changed
constexpr int kSweeps = 8;                       // of the search for fewer conflicts, in a pass
constexpr std::size_t kLongestSearch = 50'000;   // Delaunay cells looked at for one bridge
constexpr double kDiscountInRegion = 1.0 / 32.0; // of the way through a cell that lies in the region

constexpr double kPriceOfConflict = 8.0; // of the way through a cell next to a region that own is not

// Order of what is wrong with the region of a cell.
constexpr int kCostOfConflict = 2;
constexpr int kCostOfElsewhere = 1;

constexpr auto kNoComponent = std::numeric_limits<std::uint32_t>::max();

//! A Delaunay cell reached on the way between two pieces of a region.
struct Step
{
    double cost;
    std::size_t order; //!< ties go to what was reached first
    DelaunayCell cell;

    [[nodiscard]] bool operator>(const Step& other) const
    {
        return std::pair(cost, order) > std::pair(other.cost, other.order);
    }
};

class RegionRepair
{
public:
    RegionRepair(RestrictedDelaunay& restricted, double floor_radius)
        : oracle_(restricted.oracle()), triangulation_(restricted.triangulation()), floor_(floor_radius)
    {
    }

    RegionRepairReport run()
    {
        for (int pass = 0; pass < kPasses; ++pass)
        {
            const std::size_t reconciled = reconcile();
            if (join_pieces() + reconciled == 0)
                return report_;
        }
        reconcile(); // pieces apart are named as such, regions in contact would be a lie
        return report_;
    }

    std::vector<Point3> gaps()
    {
        components_ = find_region_components(triangulation_);
        is_largest_ = largest_of_each_region(components_);
        std::vector<Point3> places;
        for (std::uint32_t c = 0; c < components_.size(); ++c)
        {
            const std::vector<DelaunayCell> cells =
                is_largest_[c] ? std::vector<DelaunayCell>{} : cells_of(c);
            if (cells.empty() || is_crumb(cells))
                continue;
            for (const DelaunayCell delaunay_cell : find_way(cells))
            {
                if (delaunay_cell->info().region != components_[c].region)
                    places.push_back(centroid(corner_positions(delaunay_cell)));
            }
        }
        return places;
    }

private:
    //! Whether a facet between two regions is one the scan has, or none at all.
    [[nodiscard]] bool compatible(Region a, Region b) const
    {
        return a == b || oracle_.surface_between(a, b) != kNoSurface;
    }

    [[nodiscard]] Region across(SurfaceId surface, Region region) const
    {
        const SurfaceSides sides = oracle_.sides(surface);
        return sides.inside == region ? sides.outside : sides.inside;
    }

    //! The region that touches both; nullopt where there is none.
    [[nodiscard]] std::optional<Region> region_between(Region a, Region b) const
    {
        for (const auto& [one, other] : {std::pair{a, b}, std::pair{b, a}})
        {
            const SurfaceId around = oracle_.surface_around(one);
            if (around == kNoSurface)
                continue;
            const Region between = across(around, one);
            if (oracle_.surface_between(between, other) != kNoSurface)
                return between;
        }
        return std::nullopt;
    }

    [[nodiscard]] int conflicts(DelaunayCell delaunay_cell, Region region) const
    {
        int count = 0;
        for (int i = 0; i < 4; ++i)
            count += compatible(region, delaunay_cell->neighbor(i)->info().region) ? 0 : 1;
        return count;
    }

    //! Sweeps until no cell changes: first over all cells, then over those where something has changed or is
    //! still wrong.
    std::size_t reconcile()
    {
        std::size_t reconciled = 0;
        for (int sweep = 0; sweep < kSweeps; ++sweep)
        {
            std::vector<DelaunayCell> conflicting;
            if (std::exchange(looked_at_all_, true))
                conflicting = take_conflicting_cells();
            else
            {
                for (const DelaunayCell delaunay_cell : triangulation_.finite_cell_handles())
                    note_conflicts(delaunay_cell, conflicting);
            }
            std::size_t changed = 0;
            for (const DelaunayCell delaunay_cell : conflicting)
                changed += reconcile_with_neighbors(delaunay_cell) ? 1 : 0;
            reconciled += changed;
            if (changed == 0)
                break;
        }
        report_.cells_reconciled += reconciled;
        return reconciled;
    }

    void note_conflicts(DelaunayCell delaunay_cell, std::vector<DelaunayCell>& conflicting) const
    {
        if (conflicts(delaunay_cell, delaunay_cell->info().region) > 0)
            conflicting.push_back(delaunay_cell);
    }

    //! Among the cells looked at last and those changed since, with their neighbours.
    std::vector<DelaunayCell> take_conflicting_cells()
    {
        std::vector<DelaunayCell> conflicting;
        for (const DelaunayCell delaunay_cell : std::exchange(suspects_, {}))
            note_conflicts(delaunay_cell, conflicting);
        for (const DelaunayCell delaunay_cell : std::exchange(changed_, {}))
        {
            for (int i = 0; i < 4; ++i)
            {
                if (!triangulation_.is_infinite(delaunay_cell->neighbor(i)))
                    note_conflicts(delaunay_cell->neighbor(i), conflicting);
            }
            note_conflicts(delaunay_cell, conflicting);
        }
        return conflicting;
    }

    //! Gives a cell with a facet that the scan does not have the region that leaves fewest such facets. Every
    //! change lowers their number.
    bool reconcile_with_neighbors(DelaunayCell delaunay_cell)
    {
        const Region own = delaunay_cell->info().region;
        const int own_conflicts = conflicts(delaunay_cell, own);
        if (own_conflicts == 0)
            return false;
        const Region here = oracle_.region(centroid(corner_positions(delaunay_cell)));
        std::vector<Region> candidates{here};
        for (int i = 0; i < 4; ++i)
        {
            const Region next = delaunay_cell->neighbor(i)->info().region;
            candidates.push_back(next);
            if (compatible(own, next))
                continue;
            if (const auto between = region_between(own, next))
                candidates.push_back(*between);
        }
        const auto cost = [&](Region region) {
            return kCostOfConflict * conflicts(delaunay_cell, region) +
                   (region == here ? 0 : kCostOfElsewhere);
        };
        const Region best = *std::min_element(candidates.begin(), candidates.end(),
                                              [&](Region a, Region b) { return cost(a) < cost(b); });
        const bool better = conflicts(delaunay_cell, best) < own_conflicts;
        if (better)
            change_region(delaunay_cell, best, delaunay_cell->info().component);
        else
            suspects_.push_back(delaunay_cell);
        return better;
    }

    //! Dissolves pieces of regions that lie elsewhere, and joins those that do not to the largest piece.
    std::size_t join_pieces()
    {
        components_ = find_region_components(triangulation_);
        is_largest_ = largest_of_each_region(components_);
        report_.pieces_left_apart = 0;
        std::size_t changed = 0;
        for (std::uint32_t c = 0; c < components_.size(); ++c)
        {
            if (is_largest_[c])
                continue;
            const std::vector<DelaunayCell> cells = cells_of(c);
            if (cells.empty())
                continue; // changed since
            if (is_crumb(cells))
            {
                dissolve(cells);
                ++report_.crumbs_dissolved;
                ++changed;
            }
            else if (bridge(cells))
            {
                ++report_.necks_bridged;
                ++changed;
            }
            else
                ++report_.pieces_left_apart;
        }
        return changed;
    }

    [[nodiscard]] std::vector<DelaunayCell> cells_of(std::uint32_t component) const
    {
        std::vector<DelaunayCell> cells;
        const auto belongs = [&](DelaunayCell delaunay_cell)
        {
            return delaunay_cell->info().component == component &&
                   delaunay_cell->info().region == components_[component].region;
        };
        if (!belongs(components_[component].first))
            return cells;
        const auto visit = [&](DelaunayCell delaunay_cell)
        {
            delaunay_cell->info().component = kNoComponent;
            cells.push_back(delaunay_cell);
        };
        visit(components_[component].first);
        for (std::size_t next = 0; next < cells.size(); ++next)
        {
            for (int i = 0; i < 4; ++i)
            {
                if (belongs(cells[next]->neighbor(i)))
                    visit(cells[next]->neighbor(i));
            }
        }
        for (const DelaunayCell delaunay_cell : cells)
            delaunay_cell->info().component = component;
        return cells;
    }

    //! Whether cells of one region are a by-product of slivers: thinner than the floor throughout, or where
    //! the region is not.
    [[nodiscard]] bool is_crumb(const std::vector<DelaunayCell>& cells) const
    {
        const auto is_infinite = [&](DelaunayCell c) { return triangulation_.is_infinite(c); };
        if (std::any_of(cells.begin(), cells.end(), is_infinite))
            return false;
        const auto is_thin = [&](DelaunayCell c) { return least_altitude(corner_positions(c)) <= floor_; };
        const auto is_elsewhere = [&](DelaunayCell c)
        { return oracle_.region(centroid(corner_positions(c))) != c->info().region; };
        return std::all_of(cells.begin(), cells.end(), is_thin) ||
               std::all_of(cells.begin(), cells.end(), is_elsewhere);
    }

    //! Gives the cells to the region they share most facets with.
    void dissolve(const std::vector<DelaunayCell>& cells)
    {
        const Region own = cells.front()->info().region;
        std::unordered_map<Region, int> facets;
        for (const DelaunayCell delaunay_cell : cells)
            for (int i = 0; i < 4; ++i)
                ++facets[delaunay_cell->neighbor(i)->info().region];
        facets.erase(own);
        const auto most =
            std::max_element(facets.begin(), facets.end(),
                             [](const auto& a, const auto& b)
                             { return std::pair(a.second, a.first) < std::pair(b.second, b.first); });
        for (const DelaunayCell delaunay_cell : cells)
            change_region(delaunay_cell, most->first, kNoComponent);
    }

    //! Gives the cells on the cheapest way to the largest piece of the region to it. False where none is
    //! found.
    bool bridge(const std::vector<DelaunayCell>& cells)
    {
        const std::vector<DelaunayCell> way = find_way(cells);
        if (way.empty())
            return false;
        const std::uint32_t component = way.front()->info().component;
        for (const DelaunayCell delaunay_cell : way)
            change_region(delaunay_cell, cells.front()->info().region, component);
        return true;
    }

    //! The cells on the cheapest way from the largest piece of a region, first, to another one, last; empty
    //! where none is found.
    [[nodiscard]] std::vector<DelaunayCell> find_way(const std::vector<DelaunayCell>& cells) const
    {
        const Region own = cells.front()->info().region;
        std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
        std::unordered_map<const void*, std::pair<double, DelaunayCell>> reached; // cost, cell before
        const auto reach = [&](DelaunayCell delaunay_cell, double cost, DelaunayCell before)
        {
            const auto [entry, added] = reached.try_emplace(&*delaunay_cell, cost, before);
            if (!added && entry->second.first <= cost)
                return;
            entry->second = {cost, before};
            front.push({cost, reached.size() + front.size(), delaunay_cell});
        };
        for (const DelaunayCell delaunay_cell : cells)
            reach(delaunay_cell, 0.0, {});
        while (!front.empty() && reached.size() < cells.size() + kLongestSearch)
        {
            const Step step = front.top();
            front.pop();
            if (step.cost > reached[&*step.cell].first)
                continue;
            if (is_goal(step.cell, own))
            {
                std::vector<DelaunayCell> way;
                for (DelaunayCell at = step.cell; at != DelaunayCell(); at = reached[&*at].second)
                    way.push_back(at);
                return way;
            }
            for (int i = 0; i < 4; ++i)
            {
                const DelaunayCell next = step.cell->neighbor(i);
                if (const auto price = price_of(next, own))
                    reach(next, step.cost + *price, step.cell);
            }
        }
        return {};
    }

    [[nodiscard]] bool is_goal(DelaunayCell delaunay_cell, Region own) const
    {
        const DelaunayCellData& data = delaunay_cell->info();
        return data.region == own && data.component < components_.size() && is_largest_[data.component];
    }

    //! What a bridge of region `own` pays for a cell; nullopt where it must not pass.
    [[nodiscard]] std::optional<double> price_of(DelaunayCell delaunay_cell, Region own) const
    {
        const Region region = delaunay_cell->info().region;
        if (region == own)
            return 0.0;
        if (triangulation_.is_infinite(delaunay_cell) || is_inside(region) == is_inside(own))
            return std::nullopt;
        const double length = longest_edge(corner_positions(delaunay_cell)) *
                              (1.0 + kPriceOfConflict * conflicts(delaunay_cell, own));
        return oracle_.region(centroid(corner_positions(delaunay_cell))) == own ? kDiscountInRegion * length
                                                                                : length;
    }

    void change_region(DelaunayCell delaunay_cell, Region region, std::uint32_t component)
    {
        changed_.push_back(delaunay_cell);
        delaunay_cell->info().region = region;
        delaunay_cell->info().component = component;
        mark_pinched(delaunay_cell);
    }

    static void mark_pinched(DelaunayCell delaunay_cell)
    {
        for (int i = 0; i < 4; ++i)
            delaunay_cell->vertex(i)->info().pinched = true; // as far as is known
    }

    const SurfaceOracle& oracle_;
    const Triangulation& triangulation_;
    double floor_;
    bool looked_at_all_ = false;
    std::vector<DelaunayCell> suspects_; //!< with conflicts that could not be mended, as far as is known
    std::vector<DelaunayCell> changed_;  //!< since the last sweep
    std::vector<RegionComponent> components_;
    std::vector<bool> is_largest_;
    RegionRepairReport report_;
};

} // namespace

std::vector<Point3> find_gaps(RestrictedDelaunay& restricted, double floor_radius)
{
    return restricted.oracle().surface_count() == 0 ? std::vector<Point3>{}
                                                    : RegionRepair(restricted, floor_radius).gaps();
}

RegionRepairReport repair_regions(RestrictedDelaunay& restricted, double floor_radius)
{
    return restricted.oracle().surface_count() == 0 ? RegionRepairReport{}
                                                    : RegionRepair(restricted, floor_radius).run();
}

} // namespace voroprobe
