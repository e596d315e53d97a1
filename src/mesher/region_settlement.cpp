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

// Times that regions are joined again after the inside was given up somewhere.
constexpr int kCarvingsRepaired = 4;

//! The outside region next to a cell, or else next to its region.
Region region_outside(const SurfaceOracle& oracle, DelaunayCell delaunay_cell)
{
    for (int i = 0; i < 4; ++i)
    {
        if (separates_sides(delaunay_cell, i))
            return delaunay_cell->neighbor(i)->info().region;
    }
    return oracle.sides(oracle.surface_around(delaunay_cell->info().region)).outside;
}

} // namespace

void RegionSettlement::take_in_new_cells()
{
    if (table_)
    {
        note_changes(*table_, regions_);
        if (const auto made = table_->update())
        {
            note_new_cells(*table_, *made, regions_);
            note_new_cells(*table_, *made, handles_);
            new_cells_.insert(new_cells_.end(), made->begin(), made->end());
            forget_umbrellas_at_changes();
            return;
        }
        forget();
    }
    table_.emplace(restricted_.triangulation(), workers_);
}

//! Refinement may have looked at them, but not with the regions that were settled.
void RegionSettlement::forget_umbrellas_at_changes()
{
    for (const CellTable::Change& change : table_->changes())
    {
        for (int i = 0; i < 4; ++i)
            table_->cell(change.cell)->vertex(i)->info().pinched = true;
    }
}

void RegionSettlement::forget()
{
    table_.reset();
    is_settled_ = false;
    new_cells_.clear();
    regions_ = {};
    handles_ = {.necks = std::move(handles_.necks), .trials = {}, .changed_at = {}};
    handle_changes_.clear();
    report_ = {};
    cells_relabelled_ = 0;
}

std::vector<Point3> RegionSettlement::find_gaps()
{
    if (restricted_.oracle().surface_count() == 0)
        return {};
    if (is_settled_)
        forget();
    take_in_new_cells();
    return voroprobe::find_gaps(restricted_.oracle(), *table_, options_.floor_radius, regions_);
}

void RegionSettlement::settle(bool handles)
{
    take_in_new_cells();
    if (is_settled_ && new_cells_.empty())
        return;
    settle_regions();
    lacking_.clear();
    coarse_necks_.clear();
    other_missed_necks_.clear();
    if (handles && restricted_.oracle().surface_count() > 0)
        settle_handles();
}

void RegionSettlement::settle_regions()
{
    undo_broken_changes();
    repair();
    const std::size_t relabelled =
        relabel_pinched_cells(restricted_, *table_, options_, vertices_to_look_at());
    if (relabelled > 0)
        repair(); // a cell that mends an edge may have been a neck
    cells_relabelled_ += relabelled;
    new_cells_.clear();
    is_settled_ = true;
}

void RegionSettlement::repair()
{
    const RegionRepairReport report =
        repair_regions(restricted_.oracle(), *table_, options_.floor_radius, regions_);
    report_.cells_reconciled += report.cells_reconciled;
    report_.crumbs_dissolved += report.crumbs_dissolved;
    report_.necks_bridged += report.necks_bridged;
    report_.pieces_left_apart = report.pieces_left_apart; // as it is now
}

//! Pinched ones, as far as is known: all the first time, then those whose Delaunay cells are others.
std::vector<VertexHandle> RegionSettlement::vertices_to_look_at()
{
    std::vector<bool> is_changed(restricted_.vertex_index_bound(), !is_settled_);
    for (const CellTable::Number cell : new_cells_)
    {
        for (int i = 0; i < 4; ++i)
            is_changed[table_->cell(cell)->vertex(i)->info().index] = true;
    }
    std::vector<VertexHandle> vertices;
    for (const VertexHandle vertex : restricted_.triangulation().finite_vertex_handles())
    {
        const VertexData& data = vertex->info();
        if (data.pinched && is_changed[data.index] && data.origin != VertexOrigin::kSentinel)
            vertices.push_back(vertex);
    }
    return vertices;
}

//! Those that cells had a part in that are gone now.
void RegionSettlement::undo_broken_changes()
{
    std::vector<bool> is_new(table_->size(), false);
    for (const CellTable::Number cell : new_cells_)
        is_new[cell] = true;
    const auto is_broken = [&](const HandleChange& change)
    {
        return std::any_of(change.cells.begin(), change.cells.end(),
                           [&](CellTable::Number cell) { return is_new[cell]; });
    };
    for (auto change = handle_changes_.rbegin(); change != handle_changes_.rend(); ++change)
    {
        for (std::size_t c = 0; is_broken(*change) && c < change->cells.size(); ++c)
        {
            if (!is_new[change->cells[c]])
                table_->set_region(change->cells[c], change->former_regions[c]);
        }
    }
    std::erase_if(handle_changes_, is_broken);
}

void RegionSettlement::settle_handles()
{
    MeshedSurfaces meshed = find_meshed_surfaces(restricted_, *table_);
    vertices_on_surfaces_ = std::move(meshed.vertices);
    longest_side_ = meshed.longest_side;
    lacking_ = lacking_euler(restricted_.oracle(), std::move(meshed.doubled_euler));
    if (!lacks_any())
        return;
    if (handles_.necks.empty())
        handles_.necks = restricted_.oracle().necks();
    put_right(kLongestSideInFloors * options_.floor_radius);
}

void RegionSettlement::put_right(double longest_side)
{
    HandleRepairReport report = repair_handles(restricted_, *table_, handles_, longest_side, lacking_);
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
        add(repair_slivers(restricted_, *table_, handles_, kLongestSideInFloors * options_.floor_radius,
                           lacking_));
    improve_angles();
    handles_ = {};
    vertices_on_surfaces_ = std::vector<SurfacePoint>();
}

void RegionSettlement::improve_angles()
{
    changes_before_angles_ = table_->changes().size();
    if (restricted_.oracle().surface_count() > 0)
        cells_relabelled_for_angles_ = relabel_sharp_cells(restricted_, *table_, options_);
}

void RegionSettlement::unsettle()
{
    table_->give_back_regions();
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

std::vector<SurfaceId> RegionSettlement::surfaces_without_vertices() const
{
    std::vector<bool> has_vertex(lacking_.size(), false);
    for (const SurfacePoint& vertex : vertices_on_surfaces_)
        has_vertex[static_cast<std::size_t>(vertex.surface)] = true;
    std::vector<SurfaceId> surfaces;
    for (std::size_t surface = 0; surface < has_vertex.size(); ++surface)
    {
        if (!has_vertex[surface])
            surfaces.push_back(static_cast<SurfaceId>(surface));
    }
    return surfaces;
}

bool RegionSettlement::undo_handles_at(std::span<const VertexHandle> vertices)
{
    const auto is_at = [&](const HandleChange& change)
    {
        return std::any_of(change.cells.begin(), change.cells.end(),
                           [&](CellTable::Number cell)
                           {
                               return std::any_of(vertices.begin(), vertices.end(),
                                                  [&](VertexHandle vertex)
                                                  { return table_->cell(cell)->has_vertex(vertex); });
                           });
    };
    if (std::none_of(handle_changes_.begin(), handle_changes_.end(), is_at))
        return false;
    // Later changes may have been made to the cells of earlier ones: the last is undone first.
    table_->undo_changes_after(changes_before_angles_);
    for (std::size_t c = handle_changes_.size(); c-- > 0;)
    {
        if (!is_at(handle_changes_[c]))
            continue;
        undo(handle_changes_[c], *table_);
        for (const auto& [surface, sum] : handle_changes_[c].gained)
            lacking_[static_cast<std::size_t>(surface)] += sum;
        handle_changes_.erase(handle_changes_.begin() + static_cast<std::ptrdiff_t>(c));
    }
    repair(); // what is undone may have held a region together
    improve_angles();
    return true;
}

void RegionSettlement::carve(std::span<const VertexHandle> vertices)
{
    std::vector<DelaunayCell> star;
    for (const VertexHandle vertex : vertices)
    {
        regions_.given_up.push_back(vertex->info().index);
        star.clear();
        restricted_.triangulation().incident_cells(vertex, std::back_inserter(star));
        for (const DelaunayCell delaunay_cell : star)
        {
            if (!inside(delaunay_cell))
                continue;
            table_->set_region(CellTable::number(delaunay_cell),
                               region_outside(restricted_.oracle(), delaunay_cell));
            for (int i = 0; i < 4; ++i)
                delaunay_cell->vertex(i)->info().pinched = true; // as far as is known
        }
    }
    if (++carvings_ <= kCarvingsRepaired)
        repair();
    changes_before_angles_ = table_->changes().size(); // undoing handles does not bring it back
}

void RegionSettlement::count(MeshingStatistics& statistics) const
{
    statistics.cells_reconciled = report_.cells_reconciled;
    statistics.crumbs_dissolved = report_.crumbs_dissolved;
    statistics.necks_bridged = report_.necks_bridged;
    statistics.cells_relabelled = cells_relabelled_ + cells_relabelled_for_angles_;
    statistics.handles_mended = handle_changes_.size();
}

} // namespace voroprobe
