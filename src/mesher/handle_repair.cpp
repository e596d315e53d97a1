#include "mesher/handle_repair.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <unordered_map>

#include "mesher/cell_shape.h"
#include "mesher/euler_sums.h"

namespace voroprobe
{
namespace
{

constexpr int kPasses = 2;                    // each looks at what the one before has changed
constexpr std::size_t kMostCells = 64;        // Delaunay cells that one neck may take
constexpr std::size_t kLongestSearch = 3'000; // Delaunay cells looked at for a way around a change

// Marks in DelaunayCellData::scratch begin here: above the cells of any triangulation in memory.
constexpr std::uint32_t kFirstMark = 0x80000000U;

void set_pinched_around(const std::vector<DelaunayCell>& cells)
{
    for (const DelaunayCell delaunay_cell : cells)
        for (int i = 0; i < 4; ++i)
            delaunay_cell->vertex(i)->info().pinched = true; // as far as is known
}

//! Of the facet opposite vertex i.
double squared_longest_side(DelaunayCell delaunay_cell, int i)
{
    const Point3 a = position(delaunay_cell->vertex((i + 1) & 3));
    const Point3 b = position(delaunay_cell->vertex((i + 2) & 3));
    const Point3 c = position(delaunay_cell->vertex((i + 3) & 3));
    return std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
}

class HandleRepair
{
public:
    HandleRepair(RestrictedDelaunay& restricted, double longest_side, std::vector<long>& lacking)
        : restricted_(restricted), triangulation_(restricted.triangulation()), oracle_(restricted.oracle()),
          longest_allowed_(longest_side), lacking_(lacking)
    {
    }

    HandleRepairReport run(std::span<const Neck> necks)
    {
        const std::vector<LocatedNeck> missed = missed_necks(necks);
        for (int pass = 0; pass < kPasses && lacks_any(); ++pass)
        {
            report_.too_coarse.clear();
            report_.of_no_help.clear();
            const std::size_t before = report_.changes.size();
            for (const LocatedNeck& neck : missed)
                mend(neck);
            if (report_.changes.size() == before)
                break;
        }
        return std::move(report_);
    }

    //! Surfaces with too many handles have most of them at slivers, on either side of them.
    HandleRepairReport run_at_slivers()
    {
        for (const DelaunayCell delaunay_cell : triangulation_.finite_cell_handles())
        {
            const Region own = delaunay_cell->info().region;
            const SurfaceId around = oracle_.surface_around(own);
            if (lack_of(around) <= 0)
                continue;
            for (int i = 0; i < 4 && delaunay_cell->info().region == own; ++i)
            {
                const DelaunayCell next = delaunay_cell->neighbor(i);
                const Region other = next->info().region;
                if (oracle_.surface_between(own, other) == around && !mend_cell(delaunay_cell, other))
                    mend_cell(next, own);
            }
        }
        return std::move(report_);
    }

private:
    enum class Outcome
    {
        kChanged,
        kTooCoarse, //!< it would help, but the Delaunay cells are too large
        kRefused
    };

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

    //! A neck and the Delaunay cell that holds its middle.
    struct LocatedNeck
    {
        const Neck& neck;
        DelaunayCell holder;

        [[nodiscard]] bool is_missed() const { return holder->info().region != neck.region; }
    };

    //! Those on the wrong side of the mesh, beside surfaces that lack something.
    [[nodiscard]] std::vector<LocatedNeck> missed_necks(std::span<const Neck> necks) const
    {
        std::vector<LocatedNeck> missed;
        DelaunayCell near{};
        for (const Neck& neck : necks)
        {
            if (!is_beside_lacking_surface(neck))
                continue;
            near = triangulation_.locate(cgal_point(neck.middle), near);
            if (const LocatedNeck located{neck, near}; located.is_missed())
                missed.push_back(located);
        }
        return missed;
    }

    void mend(const LocatedNeck& located)
    {
        const Neck& neck = located.neck;
        if (!is_beside_lacking_surface(neck) || !located.is_missed())
            return;
        const std::vector<DelaunayCell> cells = cells_along(located);
        const Outcome outcome = cells.empty() ? Outcome::kRefused : change(cells, neck.region);
        if (outcome == Outcome::kTooCoarse)
            report_.too_coarse.push_back({neck, longest_side_});
        if (outcome == Outcome::kRefused)
            report_.of_no_help.push_back(neck);
    }

    bool mend_cell(DelaunayCell delaunay_cell, Region other)
    {
        if (!may_change(delaunay_cell, other) || !touches_surface_elsewhere(delaunay_cell))
            return false;
        return oracle_.region(centroid(corner_positions(delaunay_cell))) == other &&
               change({delaunay_cell}, other) == Outcome::kChanged;
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
    [[nodiscard]] std::vector<DelaunayCell> cells_along(const LocatedNeck& located) const
    {
        std::vector<DelaunayCell> cells;
        for (const Point3& end : located.neck.ends)
        {
            if (!go_straight(located, end, cells))
                return {};
        }
        return cells.size() > kMostCells ? std::vector<DelaunayCell>{} : cells;
    }

    //! Adds the cells on the way to one end; false where something in the way may not change.
    bool go_straight(const LocatedNeck& located, const Point3& end, std::vector<DelaunayCell>& cells) const
    {
        const Neck& neck = located.neck;
        DelaunayCell last{};
        for (const DelaunayCell delaunay_cell : triangulation_.segment_traverser_cell_handles(
                 cgal_point(neck.middle), cgal_point(end), located.holder))
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

    //! Gives the cells to the region where that helps; otherwise changes nothing. Large facets would be far
    //! from the surface: their cells reach beyond the neck.
    Outcome change(const std::vector<DelaunayCell>& cells, Region region)
    {
        HandleChange made = make_change(cells, region);
        const bool allowed =
            helps(made.gained) && !touches_others(cells) && leaves_whole(cells, region, made.former_regions);
        longest_side_ = longest_side(cells);
        if (!allowed || longest_side_ > longest_allowed_)
        {
            undo(made);
            return allowed ? Outcome::kTooCoarse : Outcome::kRefused;
        }
        for (const auto& [surface, sum] : made.gained)
            lacking_[static_cast<std::size_t>(surface)] -= sum;
        set_pinched_around(cells);
        report_.changes.push_back(std::move(made));
        return Outcome::kChanged;
    }

    [[nodiscard]] HandleChange make_change(const std::vector<DelaunayCell>& cells, Region region) const
    {
        const DoubledEuler before = doubled_euler_around(restricted_, cells);
        HandleChange made{cells, {}, {}};
        for (const DelaunayCell delaunay_cell : cells)
        {
            made.former_regions.push_back(delaunay_cell->info().region);
            delaunay_cell->info().region = region;
        }
        made.gained = doubled_euler_around(restricted_, cells);
        for (const auto& [surface, sum] : before)
            made.gained[surface] -= sum;
        made.gained.erase(kNoSurface);
        return made;
    }

    [[nodiscard]] bool helps(const DoubledEuler& gained) const
    {
        long nearer = 0;
        for (const auto& [surface, sum] : gained)
            nearer += std::abs(lack_of(surface)) - std::abs(lack_of(surface) - sum);
        return nearer > 0;
    }

    //! Of the odd facets of the cells.
    [[nodiscard]] double longest_side(const std::vector<DelaunayCell>& cells) const
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

    //! Whether a cell touches a region that is no neighbour of its own in the scan.
    [[nodiscard]] bool touches_others(const std::vector<DelaunayCell>& cells) const
    {
        for (const DelaunayCell delaunay_cell : cells)
        {
            const Region own = delaunay_cell->info().region;
            for (int i = 0; i < 4; ++i)
            {
                const Region other = delaunay_cell->neighbor(i)->info().region;
                if (other != own && oracle_.surface_between(other, own) == kNoSurface)
                    return true;
            }
        }
        return false;
    }

    //! Whether the cells are connected to their region, and what they leave of the former ones is still
    //! connected around them. A way through edges and corners leads through cells that share no facets.
    [[nodiscard]] bool leaves_whole(const std::vector<DelaunayCell>& cells, Region region,
                                    std::vector<Region> regions)
    {
        regions.push_back(region);
        std::sort(regions.begin(), regions.end());
        regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
        return std::all_of(regions.begin(), regions.end(),
                           [&](Region each) { return is_connected_around(cells, each); });
    }

    [[nodiscard]] bool is_connected_around(const std::vector<DelaunayCell>& cells, Region region)
    {
        const std::uint32_t wanted = next_mark_++;
        const std::uint32_t reached = next_mark_++;
        std::size_t missing = 0;
        std::vector<DelaunayCell> front;
        const auto want = [&](DelaunayCell delaunay_cell)
        {
            if (delaunay_cell->info().region != region || delaunay_cell->info().scratch == wanted)
                return;
            delaunay_cell->info().scratch = wanted;
            ++missing;
            front = {delaunay_cell};
        };
        for (const DelaunayCell delaunay_cell : cells)
        {
            want(delaunay_cell);
            for (int i = 0; i < 4; ++i)
                want(delaunay_cell->neighbor(i));
        }
        if (missing == 0)
            return false; // nothing of it would be left here
        front.front()->info().scratch = reached;
        --missing;
        for (std::size_t at = 0; at < front.size() && missing > 0 && at < kLongestSearch; ++at)
        {
            for (int i = 0; i < 4; ++i)
            {
                const DelaunayCell next = front[at]->neighbor(i);
                if (next->info().region != region || next->info().scratch == reached)
                    continue;
                missing -= next->info().scratch == wanted ? 1 : 0;
                next->info().scratch = reached;
                front.push_back(next);
            }
        }
        return missing == 0;
    }

    RestrictedDelaunay& restricted_;
    const Triangulation& triangulation_;
    const SurfaceOracle& oracle_;
    double longest_allowed_;     //!< side of the facets that a change makes
    std::vector<long>& lacking_; //!< by surface
    HandleRepairReport report_;
    double longest_side_ = 0.0; //!< of the facets that the last change made, or would have made
    std::uint32_t next_mark_ = kFirstMark;
};

} // namespace

std::vector<long> lacking_euler(const RestrictedDelaunay& restricted)
{
    std::vector<long> lacking = doubled_euler_of_surfaces(restricted);
    for (std::size_t surface = 0; surface < lacking.size(); ++surface)
    {
        const int wanted = restricted.oracle().euler_characteristic(static_cast<SurfaceId>(surface));
        lacking[surface] = 2L * wanted - lacking[surface];
    }
    return lacking;
}

HandleRepairReport repair_handles(RestrictedDelaunay& restricted, std::span<const Neck> necks,
                                  double longest_side, std::vector<long>& lacking)
{
    return HandleRepair(restricted, longest_side, lacking).run(necks);
}

std::vector<HandleChange> repair_slivers(RestrictedDelaunay& restricted, double longest_side,
                                         std::vector<long>& lacking)
{
    return HandleRepair(restricted, longest_side, lacking).run_at_slivers().changes;
}

void undo(const HandleChange& change)
{
    for (std::size_t c = 0; c < change.cells.size(); ++c)
        change.cells[c]->info().region = change.former_regions[c];
    set_pinched_around(change.cells);
}

} // namespace voroprobe
