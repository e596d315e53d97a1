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
#include "mesher/component_update.h"

namespace voroprobe
{
namespace
{

constexpr int kPasses = 8;                        // each looks at what the one before has changed
constexpr int kSweeps = 8;                        // of the search for fewer conflicts, in a pass
constexpr std::size_t kLongestSearch = 2'000'000; // Delaunay cells looked at for one bridge
constexpr double kDiscountInRegion = 1.0 / 32.0;  // of the way through a cell that lies in the region

constexpr double kPriceOfConflict = 8.0; // of the way through a cell next to a region that own is not

// Order of what is wrong with the region of a cell.
constexpr int kCostOfConflict = 2;
constexpr int kCostOfElsewhere = 1;

using Number = CellTable::Number;
constexpr auto kNoCell = std::numeric_limits<Number>::max();
constexpr auto kNoComponent = std::numeric_limits<std::uint32_t>::max();

//! A Delaunay cell reached on the way between two pieces of a region.
struct Step
{
    double cost;
    std::size_t order; //!< ties go to what was reached first
    Number cell;

    [[nodiscard]] bool operator>(const Step& other) const
    {
        return std::pair(cost, order) > std::pair(other.cost, other.order);
    }
};

class RegionRepair
{
public:
    RegionRepair(const SurfaceOracle& oracle, CellTable& table, double floor_radius,
                 RegionRepairMemory& memory)
        : oracle_(oracle), table_(table), floor_(floor_radius), memory_(memory)
    {
        note_changes(table, memory);
        if (memory.components && !memory.changed.empty() &&
            !update_components(table, memory.changed, *memory.components))
            memory.components.reset();
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
        count_pieces_apart();
        return report_;
    }

    std::vector<Point3> gaps()
    {
        find_components();
        std::vector<Point3> places;
        for (std::uint32_t c = 0; c < components().size(); ++c)
        {
            const std::vector<Number> cells = is_largest_[c] ? std::vector<Number>{} : cells_of(c);
            if (cells.empty() || is_crumb(cells))
                continue;
            for (const Number cell : find_way(cells))
            {
                if (table_.region(cell) != components()[c].region)
                    places.push_back(middle(cell));
            }
        }
        return places;
    }

private:
    void find_components()
    {
        if (!memory_.components)
            memory_.components = find_region_components(table_);
        is_largest_ = largest_of_each_region(components());
    }

    [[nodiscard]] const std::vector<RegionComponent>& components() const
    {
        return memory_.components->components;
    }

    //! The index of a cell's component; kNoComponent where it was left out.
    [[nodiscard]] std::uint32_t& component_of(Number cell) { return memory_.components->of_cell[cell]; }
    [[nodiscard]] std::uint32_t component_of(Number cell) const { return memory_.components->of_cell[cell]; }

    [[nodiscard]] Point3 middle(Number cell) const { return centroid(corner_positions(table_.cell(cell))); }

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

    [[nodiscard]] int conflicts(Number cell, Region region) const
    {
        int count = 0;
        for (const Number next : table_.neighbors(cell))
            count += compatible(region, table_.region(next)) ? 0 : 1;
        return count;
    }

    //! Sweeps until no cell changes: first over all cells, then over those where something has changed or is
    //! still wrong.
    std::size_t reconcile()
    {
        std::size_t reconciled = 0;
        for (int sweep = 0; sweep < kSweeps; ++sweep)
        {
            std::vector<Number> conflicting = take_conflicting_cells();
            std::size_t changed = 0;
            for (const Number cell : conflicting)
                changed += reconcile_with_neighbors(cell) ? 1 : 0;
            reconciled += changed;
            if (changed == 0)
                break;
        }
        if (reconciled > 0)
            memory_.components.reset();
        report_.cells_reconciled += reconciled;
        return reconciled;
    }

    void note_conflicts(Number cell, std::vector<Number>& conflicting) const
    {
        if (!table_.is_infinite(cell) && conflicts(cell, table_.region(cell)) > 0)
            conflicting.push_back(cell);
    }

    //! Of all cells the first time; then among those looked at last and those changed since, with their
    //! neighbours.
    std::vector<Number> take_conflicting_cells()
    {
        std::vector<Number> conflicting;
        const auto note_around = [&](Number cell)
        {
            for (const Number next : table_.neighbors(cell))
                note_conflicts(next, conflicting);
            note_conflicts(cell, conflicting);
        };
        const std::vector<CellTable::Change>& changes = table_.changes();
        if (std::exchange(memory_.looked_at_all, true))
        {
            for (const Number cell : memory_.suspects)
                note_conflicts(cell, conflicting);
            std::for_each(memory_.changed.begin(), memory_.changed.end(), note_around);
            for (std::size_t c = memory_.changes_seen; c < changes.size(); ++c)
                note_around(changes[c].cell);
        }
        else
        {
            for (Number cell = 0; cell < table_.size(); ++cell)
                note_conflicts(cell, conflicting);
        }
        memory_.suspects.clear();
        memory_.changed.clear();
        memory_.changes_seen = changes.size();
        return conflicting;
    }

    //! Gives a cell with a facet that the scan does not have the region that leaves fewest such facets. Every
    //! change lowers their number.
    bool reconcile_with_neighbors(Number cell)
    {
        const Region own = table_.region(cell);
        const int own_conflicts = conflicts(cell, own);
        if (own_conflicts == 0)
            return false;
        const Region here = oracle_.region(middle(cell));
        std::vector<Region> candidates{here};
        for (const Number neighbor : table_.neighbors(cell))
        {
            const Region next = table_.region(neighbor);
            candidates.push_back(next);
            if (compatible(own, next))
                continue;
            if (const auto between = region_between(own, next))
                candidates.push_back(*between);
        }
        const auto cost = [&](Region region)
        { return kCostOfConflict * conflicts(cell, region) + (region == here ? 0 : kCostOfElsewhere); };
        const Region best = *std::min_element(candidates.begin(), candidates.end(),
                                              [&](Region a, Region b) { return cost(a) < cost(b); });
        const bool better = conflicts(cell, best) < own_conflicts;
        if (better)
            change_region(cell, best);
        else
            memory_.suspects.push_back(cell);
        return better;
    }

    //! Dissolves pieces of regions that lie elsewhere, and joins those that do not to the largest piece.
    std::size_t join_pieces()
    {
        find_components();
        report_.pieces_left_apart = 0;
        std::size_t changed = 0;
        bool still_known = true; // the components
        for (std::uint32_t c = 0; c < components().size(); ++c)
        {
            if (is_largest_[c])
                continue;
            const std::vector<Number> cells = cells_of(c);
            if (cells.empty())
                continue; // changed since
            if (is_crumb(cells))
            {
                still_known = dissolve(cells) && still_known;
                ++report_.crumbs_dissolved;
                ++changed;
            }
            else if (bridge(cells))
            {
                still_known = false;
                ++report_.necks_bridged;
                ++changed;
            }
            else
                ++report_.pieces_left_apart;
        }
        if (!still_known)
            memory_.components.reset();
        return changed;
    }

    //! Reconciling may have taken bridges away.
    void count_pieces_apart()
    {
        memory_.components.reset();
        find_components();
        report_.pieces_left_apart =
            static_cast<std::size_t>(std::count(is_largest_.begin(), is_largest_.end(), false));
    }

    [[nodiscard]] std::vector<Number> cells_of(std::uint32_t component)
    {
        std::vector<Number> cells;
        const auto belongs = [&](Number cell)
        { return component_of(cell) == component && table_.region(cell) == components()[component].region; };
        if (!belongs(components()[component].first))
            return cells;
        const auto visit = [&](Number cell)
        {
            component_of(cell) = kNoComponent;
            cells.push_back(cell);
        };
        visit(components()[component].first);
        for (std::size_t at = 0; at < cells.size(); ++at)
        {
            for (const Number next : table_.neighbors(cells[at]))
            {
                if (belongs(next))
                    visit(next);
            }
        }
        for (const Number cell : cells)
            component_of(cell) = component;
        return cells;
    }

    //! Whether cells of one region are a by-product of slivers: thinner than the floor throughout, or where
    //! the region is not.
    [[nodiscard]] bool is_crumb(const std::vector<Number>& cells) const
    {
        if (std::any_of(cells.begin(), cells.end(), [&](Number cell) { return table_.is_infinite(cell); }))
            return false;
        const auto is_thin = [&](Number cell)
        { return least_altitude(corner_positions(table_.cell(cell))) <= floor_; };
        const auto is_elsewhere = [&](Number cell)
        { return oracle_.region(middle(cell)) != table_.region(cell); };
        return std::all_of(cells.begin(), cells.end(), is_thin) ||
               std::all_of(cells.begin(), cells.end(), is_elsewhere);
    }

    //! Gives the cells to the region they share most facets with. Whether its components are still known: the
    //! cells touch its largest one only.
    bool dissolve(const std::vector<Number>& cells)
    {
        const Region own = table_.region(cells.front());
        std::unordered_map<Region, int> facets;
        for (const Number cell : cells)
            for (const Number next : table_.neighbors(cell))
                ++facets[table_.region(next)];
        facets.erase(own);
        if (facets.empty())
            return false; // those around have been given to their region meanwhile
        const auto most =
            std::max_element(facets.begin(), facets.end(),
                             [](const auto& a, const auto& b)
                             { return std::pair(a.second, a.first) < std::pair(b.second, b.first); });
        std::uint32_t component = kNoComponent;
        bool still_known = true;
        for (const Number cell : cells)
            for (const Number next : table_.neighbors(cell))
            {
                if (table_.region(next) != most->first)
                    continue;
                component = component_of(next);
                still_known = still_known && component != kNoComponent && is_largest_[component];
            }
        for (const Number cell : cells)
        {
            change_region(cell, most->first);
            component_of(cell) = still_known ? component : kNoComponent;
        }
        return still_known;
    }

    //! Gives the cells on the cheapest way to the largest piece of the region to it. False where none is
    //! found.
    bool bridge(const std::vector<Number>& cells)
    {
        const std::vector<Number> way = find_way(cells);
        if (way.empty())
            return false;
        const std::uint32_t component = component_of(way.front());
        for (const Number cell : way)
        {
            change_region(cell, table_.region(cells.front()));
            component_of(cell) = component;
        }
        return true;
    }

    //! The cells on the cheapest way from the largest piece of a region, first, to another one, last; empty
    //! where none is found.
    [[nodiscard]] std::vector<Number> find_way(const std::vector<Number>& cells) const
    {
        const Region own = table_.region(cells.front());
        std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
        std::unordered_map<Number, std::pair<double, Number>> reached; // cost, cell before
        const auto reach = [&](Number cell, double cost, Number before)
        {
            const auto [entry, added] = reached.try_emplace(cell, cost, before);
            if (!added && entry->second.first <= cost)
                return;
            entry->second = {cost, before};
            front.push({cost, reached.size() + front.size(), cell});
        };
        for (const Number cell : cells)
            reach(cell, 0.0, kNoCell);
        while (!front.empty() && reached.size() < cells.size() + kLongestSearch)
        {
            const Step step = front.top();
            front.pop();
            if (step.cost > reached[step.cell].first)
                continue;
            if (is_goal(step.cell, own))
            {
                std::vector<Number> way;
                for (Number at = step.cell; at != kNoCell; at = reached[at].second)
                    way.push_back(at);
                return way;
            }
            for (const Number next : table_.neighbors(step.cell))
            {
                if (const auto price = price_of(next, own))
                    reach(next, step.cost + *price, step.cell);
            }
        }
        return {};
    }

    [[nodiscard]] bool is_goal(Number cell, Region own) const
    {
        const std::uint32_t component = component_of(cell);
        return table_.region(cell) == own && component < components().size() && is_largest_[component];
    }

    //! What a bridge of region `own` pays for a cell; nullopt where it must not pass.
    [[nodiscard]] std::optional<double> price_of(Number cell, Region own) const
    {
        const Region region = table_.region(cell);
        if (region == own)
            return 0.0;
        if (table_.is_infinite(cell) || is_inside(region) == is_inside(own) ||
            (is_inside(own) && is_given_up(cell)))
            return std::nullopt;
        const double length = longest_edge(corner_positions(table_.cell(cell))) *
                              (1.0 + kPriceOfConflict * conflicts(cell, own));
        return oracle_.region(middle(cell)) == own ? kDiscountInRegion * length : length;
    }

    [[nodiscard]] bool is_given_up(Number cell) const
    {
        const std::vector<std::uint32_t>& vertices = memory_.given_up;
        return std::any_of(table_.corners(cell).begin(), table_.corners(cell).end(),
                           [&](std::uint32_t corner)
                           { return std::find(vertices.begin(), vertices.end(), corner) != vertices.end(); });
    }

    void change_region(Number cell, Region region)
    {
        table_.set_region(cell, region);
        for (int i = 0; i < 4; ++i)
            table_.cell(cell)->vertex(i)->info().pinched = true; // as far as is known
    }

    const SurfaceOracle& oracle_;
    CellTable& table_;
    double floor_;
    RegionRepairMemory& memory_;
    std::vector<bool> is_largest_; //!< by component
    RegionRepairReport report_;
};

} // namespace

void note_changes(const CellTable& table, RegionRepairMemory& memory)
{
    for (std::size_t c = memory.changes_seen; c < table.changes().size(); ++c)
        memory.changed.push_back(table.changes()[c].cell);
    memory.changes_seen = table.changes().size();
}

void note_new_cells(const CellTable& table, const std::vector<CellTable::Number>& new_cells,
                    RegionRepairMemory& memory)
{
    memory.changed.insert(memory.changed.end(), new_cells.begin(), new_cells.end());
    memory.changes_seen = table.changes().size();
}

std::vector<Point3> find_gaps(const SurfaceOracle& oracle, CellTable& table, double floor_radius,
                              RegionRepairMemory& memory)
{
    return oracle.surface_count() == 0 ? std::vector<Point3>{}
                                       : RegionRepair(oracle, table, floor_radius, memory).gaps();
}

RegionRepairReport repair_regions(const SurfaceOracle& oracle, CellTable& table, double floor_radius,
                                  RegionRepairMemory& memory)
{
    return oracle.surface_count() == 0 ? RegionRepairReport{}
                                       : RegionRepair(oracle, table, floor_radius, memory).run();
}

} // namespace voroprobe
