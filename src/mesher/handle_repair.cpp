#include "mesher/handle_repair.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <unordered_map>
#include <utility>

#include "mesher/cell_shape.h"

namespace voroprobe
{
namespace
{

constexpr int kPasses = 2;                    // each looks at what the one before has changed
constexpr std::size_t kMostCells = 64;        // Delaunay cells that one neck may take
constexpr std::size_t kLongestSearch = 3'000; // Delaunay cells looked at for a way around a change

using Number = CellTable::Number;

void set_pinched_around(const CellTable& table, const std::vector<Number>& cells)
{
    for (const Number cell : cells)
        for (int i = 0; i < 4; ++i)
            table.cell(cell)->vertex(i)->info().pinched = true; // as far as is known
}

//! Of the facet opposite vertex i.
double squared_longest_side(DelaunayCell delaunay_cell, int i)
{
    const Point3 a = position(delaunay_cell->vertex((i + 1) & 3));
    const Point3 b = position(delaunay_cell->vertex((i + 2) & 3));
    const Point3 c = position(delaunay_cell->vertex((i + 3) & 3));
    return std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
}

//! Has what lies around the cell tried again.
void note_change_at(const CellTable& table, Number cell, HandleMemory& memory)
{
    for (int i = 0; i < 4; ++i)
    {
        const std::uint32_t vertex = table.cell(cell)->vertex(i)->info().index;
        if (vertex >= memory.changed_at.size())
            memory.changed_at.resize(vertex + 1, 0);
        memory.changed_at[vertex] = memory.now;
    }
}

class HandleRepair
{
public:
    HandleRepair(const RestrictedDelaunay& restricted, CellTable& table, HandleMemory& memory,
                 double longest_side, std::vector<long>& lacking)
        : restricted_(restricted), triangulation_(restricted.triangulation()), oracle_(restricted.oracle()),
          table_(table), memory_(memory), longest_allowed_(longest_side), lacking_(lacking),
          marks_(table.size(), 0)
    {
        note_changes();
    }

    HandleRepairReport run()
    {
        const std::vector<std::size_t> missed = missed_necks();
        for (int pass = 0; pass < kPasses && lacks_any(); ++pass)
        {
            report_.too_coarse.clear();
            report_.of_no_help.clear();
            const std::size_t before = report_.changes.size();
            for (const std::size_t neck : missed)
                mend(neck);
            if (report_.changes.size() == before)
                break;
        }
        return std::move(report_);
    }

    //! Surfaces with too many handles have most of them at slivers, on either side of them.
    HandleRepairReport run_at_slivers()
    {
        for (Number cell = 0; cell < table_.size(); ++cell)
        {
            const Region own = table_.region(cell);
            const SurfaceId around = oracle_.surface_around(own);
            if (lack_of(around) <= 0 || table_.is_infinite(cell))
                continue;
            for (std::size_t i = 0; i < 4 && table_.region(cell) == own; ++i)
            {
                const Number next = table_.neighbors(cell)[i];
                const Region other = table_.region(next);
                if (other != own && oracle_.surface_between(own, other) == around && !mend_cell(cell, other))
                    mend_cell(next, own);
            }
        }
        return std::move(report_);
    }

private:
    [[nodiscard]] bool lacks_any() const
    {
        return std::any_of(lacking_.begin(), lacking_.end(), [](long lack) { return lack != 0; });
    }

    [[nodiscard]] long lack_of(SurfaceId surface) const
    {
        return surface == kNoSurface ? 0 : lacking_[static_cast<std::size_t>(surface)];
    }

    [[nodiscard]] bool is_beside_lacking_surface(const Neck& neck) const
    {
        return std::any_of(neck.surfaces.begin(), neck.surfaces.end(),
                           [&](SurfaceId surface) { return lack_of(surface) != 0; });
    }

    //! Whether the middle of the neck lies on the wrong side of the mesh. \pre It is located.
    [[nodiscard]] bool is_missed(std::size_t neck) const
    {
        return table_.region(memory_.trials[neck].holder) != memory_.necks[neck].region;
    }

    //! Those on the wrong side of the mesh, beside surfaces that lack something.
    [[nodiscard]] std::vector<std::size_t> missed_necks()
    {
        std::vector<std::size_t> missed;
        DelaunayCell near{};
        for (std::size_t n = 0; n < memory_.necks.size(); ++n)
        {
            if (!is_beside_lacking_surface(memory_.necks[n]))
                continue;
            Number& holder = memory_.trials[n].holder;
            if (holder == NeckTrial::kNoCell)
                holder = CellTable::number(triangulation_.locate(cgal_point(memory_.necks[n].middle), near));
            near = table_.cell(holder);
            if (is_missed(n))
                missed.push_back(n);
        }
        return missed;
    }

    void mend(std::size_t n)
    {
        const Neck& neck = memory_.necks[n];
        if (!is_beside_lacking_surface(neck) || !is_missed(n))
            return;
        NeckTrial& trial = memory_.trials[n];
        if (!is_up_to_date(trial))
        {
            trial.cells = numbers_of(cells_along(neck, table_.cell(trial.holder)));
            trial.change = try_change(trial.cells, neck.region);
            trial.tried_at = memory_.now;
        }
        if (!is_good(trial.change))
            report_.of_no_help.push_back(neck);
        else if (trial.change.longest_side > longest_allowed_)
            report_.too_coarse.push_back({neck, trial.change.longest_side});
        else
            make(trial.cells, neck.region, trial.change.gained);
    }

    //! Whether nothing has changed around the cells that the trial is about.
    [[nodiscard]] bool is_up_to_date(const NeckTrial& trial) const
    {
        const auto is_as_it_was = [&](Number cell)
        {
            for (int i = 0; i < 4; ++i)
            {
                const std::uint32_t vertex = table_.cell(cell)->vertex(i)->info().index;
                if (vertex < memory_.changed_at.size() && memory_.changed_at[vertex] >= trial.tried_at)
                    return false;
            }
            return true;
        };
        return trial.tried_at > 0 && is_as_it_was(trial.holder) &&
               std::all_of(trial.cells.begin(), trial.cells.end(), is_as_it_was) &&
               (trial.change.is_possible.has_value() || !helps(trial.change.gained));
    }

    [[nodiscard]] bool is_good(const TriedChange& change) const
    {
        return helps(change.gained) && change.is_possible.value_or(false);
    }

    bool mend_cell(Number cell, Region other)
    {
        const DelaunayCell delaunay_cell = table_.cell(cell);
        if (!may_change(delaunay_cell, other) ||
            longest_side_on_other_side(delaunay_cell) > longest_allowed_ ||
            oracle_.region(centroid(corner_positions(delaunay_cell))) != other ||
            !touches_surface_elsewhere(delaunay_cell))
            return false;
        const TriedChange tried = try_change({cell}, other);
        const bool good = is_good(tried) && tried.longest_side <= longest_allowed_;
        if (good)
            make({cell}, other, tried.gained);
        return good;
    }

    //! Of the facets of the cell that would be odd if it were on the other side: those that are not.
    [[nodiscard]] static double longest_side_on_other_side(DelaunayCell delaunay_cell)
    {
        double squared = 0.0;
        for (int i = 0; i < 4; ++i)
        {
            if (!separates_sides(delaunay_cell, i))
                squared = std::max(squared, squared_longest_side(delaunay_cell, i));
        }
        return std::sqrt(squared);
    }

    //! Whether an edge of the cell that is on none of its odd facets is on others. If not, the surface only
    //! moves from some of its facets to the others when it changes sides.
    [[nodiscard]] bool touches_surface_elsewhere(DelaunayCell delaunay_cell) const
    {
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j)
            {
                const auto is_on_odd_facet = [&](int opposite)
                { return opposite != i && opposite != j && separates_sides(delaunay_cell, opposite); };
                if (is_on_odd_facet(0) || is_on_odd_facet(1) || is_on_odd_facet(2) || is_on_odd_facet(3))
                    continue;
                const auto first = triangulation_.incident_cells(delaunay_cell, i, j);
                auto around = first;
                while (++around != first)
                {
                    if (inside(around) != inside(delaunay_cell))
                        return true;
                }
            }
        return false;
    }

    //! The Delaunay cells of other regions on the ways from the middle of the neck to its ends, and on to the
    //! nearest cells of its own region; empty where there is no way.
    [[nodiscard]] std::vector<DelaunayCell> cells_along(const Neck& neck, DelaunayCell holder) const
    {
        std::vector<DelaunayCell> cells;
        for (const Point3& end : neck.ends)
        {
            if (!go_straight(neck, holder, end, cells))
                return {};
        }
        return cells.size() > kMostCells ? std::vector<DelaunayCell>{} : cells;
    }

    //! Adds the cells on the way to one end; false where something in the way may not change.
    bool go_straight(const Neck& neck, DelaunayCell holder, const Point3& end,
                     std::vector<DelaunayCell>& cells) const
    {
        DelaunayCell last{};
        for (const DelaunayCell delaunay_cell :
             triangulation_.segment_traverser_cell_handles(cgal_point(neck.middle), cgal_point(end), holder))
        {
            if (delaunay_cell->info().region == neck.region)
                break;
            if (!may_change(delaunay_cell, neck.region))
                return false;
            // Through an edge or a corner the way leads to a cell that shares no facet with the last.
            const auto is_next = [&](DelaunayCell other) { return other == delaunay_cell; };
            if (last != DelaunayCell() && !last->has_neighbor(delaunay_cell) &&
                !go_on(last, neck.region, is_next, cells))
                return false;
            last = delaunay_cell;
            add(delaunay_cell, cells);
        }
        const auto is_own = [&](DelaunayCell other) { return other->info().region == neck.region; };
        return last != DelaunayCell() && go_on(last, neck.region, is_own, cells);
    }

    //! Adds the cells on the shortest way from one, through cells that may join the region, to a goal.
    template <typename IsGoal>
    bool go_on(DelaunayCell from, Region own, IsGoal is_goal, std::vector<DelaunayCell>& cells) const
    {
        std::vector<DelaunayCell> front{from};
        std::unordered_map<const void*, std::size_t> before{{&*from, 0}};
        for (std::size_t at = 0; at < front.size() && at < kMostCells; ++at)
        {
            for (int i = 0; i < 4; ++i)
            {
                const DelaunayCell next = front[at]->neighbor(i);
                if (is_goal(next))
                {
                    for (std::size_t back = at; back != 0; back = before[&*front[back]])
                        add(front[back], cells);
                    return true;
                }
                if (may_change(next, own) && before.try_emplace(&*next, at).second)
                    front.push_back(next);
            }
        }
        return false;
    }

    static void add(DelaunayCell delaunay_cell, std::vector<DelaunayCell>& cells)
    {
        if (std::find(cells.begin(), cells.end(), delaunay_cell) == cells.end())
            cells.push_back(delaunay_cell);
    }

    [[nodiscard]] static std::vector<Number> numbers_of(const std::vector<DelaunayCell>& cells)
    {
        std::vector<Number> numbers;
        std::transform(cells.begin(), cells.end(), std::back_inserter(numbers), CellTable::number);
        return numbers;
    }

    //! What reaches beyond the domain stays outside.
    [[nodiscard]] bool may_change(DelaunayCell delaunay_cell, Region to) const
    {
        if (triangulation_.is_infinite(delaunay_cell) ||
            is_inside(delaunay_cell->info().region) == is_inside(to))
            return false;
        for (int i = 0; i < 4; ++i)
        {
            if (delaunay_cell->vertex(i)->info().origin == VertexOrigin::kSentinel)
                return false;
        }
        return true;
    }

    //! What giving the cells to the region would do. Large facets would be far from the surface: their cells
    //! reach beyond the neck.
    [[nodiscard]] TriedChange try_change(const std::vector<Number>& cells, Region region)
    {
        TriedChange tried;
        tried.is_possible = false;
        if (cells.empty() || would_touch_others(cells, region))
            return tried;
        std::vector<DelaunayCell> handles;
        std::vector<Region> regions{region};
        for (const Number cell : cells)
        {
            handles.push_back(table_.cell(cell));
            regions.push_back(table_.region(cell));
        }
        const DoubledEuler before = doubled_euler_around(restricted_, handles);
        const std::size_t changes = table_.changes().size();
        for (const Number cell : cells)
            table_.set_region(cell, region);
        tried.gained = doubled_euler_around(restricted_, handles);
        for (const auto& [surface, sum] : before)
            tried.gained[surface] -= sum;
        tried.gained.erase(kNoSurface);
        tried.is_possible.reset();
        if (helps(tried.gained))
        {
            tried.is_possible = leaves_whole(cells, std::move(regions));
            tried.longest_side = longest_side(handles);
        }
        table_.undo_changes_after(changes);
        return tried;
    }

    void make(const std::vector<Number>& cells, Region region, const DoubledEuler& gained)
    {
        HandleChange made{cells, {}, gained};
        for (const Number cell : cells)
        {
            made.former_regions.push_back(table_.region(cell));
            table_.set_region(cell, region);
        }
        for (const auto& [surface, sum] : gained)
            lacking_[static_cast<std::size_t>(surface)] -= sum;
        set_pinched_around(table_, cells);
        note_changes();
        report_.changes.push_back(std::move(made));
    }

    void note_changes()
    {
        const std::vector<CellTable::Change>& changes = table_.changes();
        for (; memory_.changes_seen < changes.size(); ++memory_.changes_seen)
            note_change_at(table_, changes[memory_.changes_seen].cell, memory_);
        ++memory_.now;
    }

    [[nodiscard]] bool helps(const DoubledEuler& gained) const
    {
        long nearer = 0;
        for (const auto& [surface, sum] : gained)
            nearer += std::abs(lack_of(surface)) - std::abs(lack_of(surface) - sum);
        return nearer > 0;
    }

    //! Of the odd facets of the cells.
    [[nodiscard]] static double longest_side(const std::vector<DelaunayCell>& cells)
    {
        double squared = 0.0;
        for (const DelaunayCell delaunay_cell : cells)
            for (int i = 0; i < 4; ++i)
            {
                if (separates_sides(delaunay_cell, i))
                    squared = std::max(squared, squared_longest_side(delaunay_cell, i));
            }
        return std::sqrt(squared);
    }

    //! Whether one of the cells, in the region, would touch a region that is no neighbour of it in the scan.
    [[nodiscard]] bool would_touch_others(const std::vector<Number>& cells, Region region) const
    {
        for (const Number cell : cells)
            for (const Number next : table_.neighbors(cell))
            {
                const Region other = table_.region(next);
                if (other != region && oracle_.surface_between(other, region) == kNoSurface &&
                    std::find(cells.begin(), cells.end(), next) == cells.end())
                    return true;
            }
        return false;
    }

    //! Whether the cells are connected to their region, and what they leave of the former ones is still
    //! connected around them. A way through edges and corners leads through cells that share no facets.
    [[nodiscard]] bool leaves_whole(const std::vector<Number>& cells, std::vector<Region> regions)
    {
        std::sort(regions.begin(), regions.end());
        regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
        return std::all_of(regions.begin(), regions.end(),
                           [&](Region each) { return is_connected_around(cells, each); });
    }

    [[nodiscard]] bool is_connected_around(const std::vector<Number>& cells, Region region)
    {
        const std::uint32_t wanted = ++last_mark_;
        const std::uint32_t reached = ++last_mark_;
        std::size_t missing = 0;
        std::vector<Number> front;
        const auto want = [&](Number cell)
        {
            if (table_.region(cell) != region || marks_[cell] == wanted)
                return;
            marks_[cell] = wanted;
            ++missing;
            front = {cell};
        };
        for (const Number cell : cells)
        {
            want(cell);
            for (const Number next : table_.neighbors(cell))
                want(next);
        }
        if (missing == 0)
            return false; // nothing of it would be left here
        marks_[front.front()] = reached;
        --missing;
        for (std::size_t at = 0; at < front.size() && missing > 0 && at < kLongestSearch; ++at)
        {
            for (const Number next : table_.neighbors(front[at]))
            {
                if (table_.region(next) != region || marks_[next] == reached)
                    continue;
                missing -= marks_[next] == wanted ? 1 : 0;
                marks_[next] = reached;
                front.push_back(next);
            }
        }
        return missing == 0;
    }

    const RestrictedDelaunay& restricted_;
    const Triangulation& triangulation_;
    const SurfaceOracle& oracle_;
    CellTable& table_;
    HandleMemory& memory_;
    double longest_allowed_;     //!< side of the facets that a change makes
    std::vector<long>& lacking_; //!< by surface
    HandleRepairReport report_;
    std::vector<std::uint32_t> marks_; //!< by cell, of the searches around changes
    std::uint32_t last_mark_ = 0;
};

} // namespace

std::vector<long> lacking_euler(const SurfaceOracle& oracle, std::vector<long> doubled_euler)
{
    for (std::size_t surface = 0; surface < doubled_euler.size(); ++surface)
    {
        const int wanted = oracle.euler_characteristic(static_cast<SurfaceId>(surface));
        doubled_euler[surface] = 2L * wanted - doubled_euler[surface];
    }
    return doubled_euler;
}

void note_new_cells(const CellTable& table, std::span<const CellTable::Number> new_cells,
                    HandleMemory& memory)
{
    std::vector<bool> is_new(table.size(), false);
    for (const Number cell : new_cells)
    {
        is_new[cell] = true;
        note_change_at(table, cell, memory);
    }
    ++memory.now;
    for (NeckTrial& trial : memory.trials)
    {
        if (trial.holder != NeckTrial::kNoCell && is_new[trial.holder])
            trial = {};
    }
    memory.changes_seen = table.changes().size();
}

HandleRepairReport repair_handles(const RestrictedDelaunay& restricted, CellTable& table,
                                  HandleMemory& memory, double longest_side, std::vector<long>& lacking)
{
    memory.trials.resize(memory.necks.size());
    return HandleRepair(restricted, table, memory, longest_side, lacking).run();
}

std::vector<HandleChange> repair_slivers(const RestrictedDelaunay& restricted, CellTable& table,
                                         HandleMemory& memory, double longest_side,
                                         std::vector<long>& lacking)
{
    return HandleRepair(restricted, table, memory, longest_side, lacking).run_at_slivers().changes;
}

void undo(const HandleChange& change, CellTable& table)
{
    for (std::size_t c = 0; c < change.cells.size(); ++c)
        table.set_region(change.cells[c], change.former_regions[c]);
    set_pinched_around(table, change.cells);
}

} // namespace voroprobe
