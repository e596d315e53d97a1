#include "mesher/region_settlement.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <utility>

namespace voroprobe
{

namespace
{

constexpr long kDoubledEulerOfHandle = 4;
constexpr long kNecksPerHandle = 4;
// Necks of a surface on the wrong side that are all refined at; more of them where a region is in pieces: one
// of them joins these.
constexpr std::size_t kFewNecks = 32;
constexpr std::size_t kFewNecksOfPieces = 1024;

// Of the facets made where handles are put right while refinement may go on: a voxel and a half, at the
// default floor.
constexpr double kLongestSideInFloors = 6.0;

} // namespace

void RegionSettlement::settle(bool handles)
{
    remember_cells();
    report_ = {};
    lacking_.clear();
    handle_changes_.clear();
    coarse_necks_.clear();
    other_missed_necks_.clear();
    settle_regions();
    if (handles && restricted_.oracle().surface_count() > 0)
        settle_handles();
}

void RegionSettlement::remember_cells()
{
    former_cells_.clear();
    former_cells_.reserve(restricted_.triangulation().number_of_cells());
    for (const DelaunayCell delaunay_cell : restricted_.triangulation().all_cell_handles())
        former_cells_.push_back({delaunay_cell->info().region, delaunay_cell->info().facet});
}

void RegionSettlement::settle_regions()
{
    CellTable table(restricted_.triangulation());
    repair(table);
    cells_relabelled_ = relabel_pinched_cells(restricted_, options_);
    if (cells_relabelled_ == 0)
        return;
    table.refresh_regions();
    repair(table); // a cell that mends an edge may have been a neck
}

void RegionSettlement::repair(CellTable& table)
{
    const RegionRepairReport report = repair_regions(restricted_.oracle(), table, options_.floor_radius);
    report_.cells_reconciled += report.cells_reconciled;
    report_.crumbs_dissolved += report.crumbs_dissolved;
    report_.necks_bridged += report.necks_bridged;
    report_.pieces_left_apart = report.pieces_left_apart; // as it is now
}

void RegionSettlement::settle_handles()
{
    lacking_ = lacking_euler(restricted_);
    if (!lacks_any())
        return;
    if (!necks_)
        necks_ = restricted_.oracle().necks();
    put_right(kLongestSideInFloors * options_.floor_radius);
}

void RegionSettlement::put_right(double longest_side)
{
    HandleRepairReport report = repair_handles(restricted_, *necks_, longest_side, lacking_);
    add(std::move(report.changes));
    coarse_necks_ = std::move(report.too_coarse);
    other_missed_necks_ = std::move(report.of_no_help);
}

void RegionSettlement::add(std::vector<HandleChange> changes)
{
    std::move(changes.begin(), changes.end(), std::back_inserter(handle_changes_));
}

bool RegionSettlement::lacks_any() const
{
    return std::any_of(lacking_.begin(), lacking_.end(), [](long lack) { return lack != 0; });
}

void RegionSettlement::finish()
{
    if (lacks_any())
        put_right(2.0 * options_.max_facet_radius);
    if (lacks_any())
        add(repair_slivers(restricted_, kLongestSideInFloors * options_.floor_radius, lacking_));
    improve_angles();
}

void RegionSettlement::improve_angles()
{
    if (restricted_.oracle().surface_count() > 0)
        side_changes_ = relabel_sharp_cells(restricted_, options_);
}

//! The last change first: a cell may have changed twice.
void RegionSettlement::undo_side_changes()
{
    for (auto change = side_changes_.rbegin(); change != side_changes_.rend(); ++change)
        change->cell->info().region = change->former;
    side_changes_.clear();
}

void RegionSettlement::unsettle()
{
    auto former = former_cells_.begin();
    for (const DelaunayCell delaunay_cell : restricted_.triangulation().all_cell_handles())
    {
        delaunay_cell->info().region = former->region;
        delaunay_cell->info().facet = former->facet;
        ++former;
    }
    handle_changes_.clear();
}

std::vector<Neck> RegionSettlement::necks_to_refine() const
{
    std::vector<CoarseNeck> by_size = coarse_necks_;
    std::stable_sort(by_size.begin(), by_size.end(),
                     [](const CoarseNeck& a, const CoarseNeck& b)
                     { return a.longest_side < b.longest_side; });
    std::vector<long> wanted(lacking_.size());
    for (std::size_t surface = 0; surface < wanted.size(); ++surface)
        wanted[surface] = kNecksPerHandle * (std::abs(lacking_[surface]) / kDoubledEulerOfHandle);
    std::vector<Neck> necks;
    for (const auto& [neck, longest_side] : by_size)
    {
        if (std::any_of(neck.surfaces.begin(), neck.surfaces.end(),
                        [&](SurfaceId surface) { return wanted[static_cast<std::size_t>(surface)]-- > 0; }))
            necks.push_back(neck);
    }
    add_where_few(other_missed_necks_, necks);
    return necks;
}

void RegionSettlement::add_where_few(const std::vector<Neck>& others, std::vector<Neck>& necks) const
{
    std::vector<std::size_t> count(lacking_.size(), 0);
    for (const Neck& neck : others)
        for (const SurfaceId surface : neck.surfaces)
            ++count[static_cast<std::size_t>(surface)];
    const std::size_t few = pieces_left_apart() > 0 ? kFewNecksOfPieces : kFewNecks;
    const auto lacks_with_few = [&](SurfaceId surface)
    {
        const auto index = static_cast<std::size_t>(surface);
        return lacking_[index] != 0 && count[index] <= few;
    };
    std::copy_if(others.begin(), others.end(), std::back_inserter(necks),
                 [&](const Neck& neck)
                 { return std::any_of(neck.surfaces.begin(), neck.surfaces.end(), lacks_with_few); });
}

bool RegionSettlement::undo_handles_at(std::span<const VertexHandle> vertices)
{
    const auto is_at = [&](const HandleChange& change)
    {
        return std::any_of(change.cells.begin(), change.cells.end(),
                           [&](DelaunayCell delaunay_cell)
                           {
                               return std::any_of(vertices.begin(), vertices.end(),
                                                  [&](VertexHandle vertex)
                                                  { return delaunay_cell->has_vertex(vertex); });
                           });
    };
    if (std::none_of(handle_changes_.begin(), handle_changes_.end(), is_at))
        return false;
    // Later changes may have been made to the cells of earlier ones: the last is undone first.
    undo_side_changes();
    for (std::size_t c = handle_changes_.size(); c-- > 0;)
    {
        if (!is_at(handle_changes_[c]))
            continue;
        undo(handle_changes_[c]);
        for (const auto& [surface, sum] : handle_changes_[c].gained)
            lacking_[static_cast<std::size_t>(surface)] += sum;
        handle_changes_.erase(handle_changes_.begin() + static_cast<std::ptrdiff_t>(c));
    }
    improve_angles();
    return true;
}

void RegionSettlement::count(MeshingStatistics& statistics) const
{
    statistics.cells_reconciled = report_.cells_reconciled;
    statistics.crumbs_dissolved = report_.crumbs_dissolved;
    statistics.necks_bridged = report_.necks_bridged;
    statistics.cells_relabelled = cells_relabelled_ + side_changes_.size();
    statistics.handles_mended = handle_changes_.size();
}

} // namespace voroprobe
