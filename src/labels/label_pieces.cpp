#include "labels/label_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "support/union_find.h"

namespace voroprobe
{

namespace
{

//! Smaller bits are slivers, as shares of a voxel: cavities of one voxel are larger, and so are bits of a
//! part that hang together at edges and corners of voxels only.
constexpr double kLeastCavityInVoxels = 0.05;
constexpr double kLeastBitInVoxels = 0.25;

//! Samples around a circumcenter along each axis, among which its part is looked for.
constexpr int kSamplesAround = 4;

} // namespace

//! The part of the cell's label that has the voxel nearest to its circumcenter, among the voxels around it.
std::optional<std::uint32_t> LabelPieces::part_of(const LabelledCellData& cell) const
{
    const Vec3 index{cell.circumcenter.x / spacing_.x, cell.circumcenter.y / spacing_.y,
                     cell.circumcenter.z / spacing_.z};
    std::optional<std::uint32_t> part;
    double nearest = 0.0;
    const auto from = [&](std::size_t axis)
    { return static_cast<int>(std::floor(index[axis])) - kSamplesAround / 2 + 1; };
    for (int k = from(2); k < from(2) + kSamplesAround; ++k)
        for (int j = from(1); j < from(1) + kSamplesAround; ++j)
            for (const LabelRun& run : survey_.row(j, k))
            {
                if (survey_.parts()[run.part].label + 1 != cell.label || run.end <= from(0) ||
                    run.first >= from(0) + kSamplesAround)
                    continue;
                const int i = std::clamp(static_cast<int>(std::lround(index.x)), run.first, run.end - 1);
                const Point3 center{spacing_.x * i, spacing_.y * j, spacing_.z * k};
                const double d = squared_distance(center, cell.circumcenter);
                if (!part || d < nearest)
                {
                    part = run.part;
                    nearest = d;
                }
            }
    return part;
}

std::vector<std::uint32_t> LabelPieces::parts_without_cell(std::span<const std::uint32_t> parts) const
{
    std::vector<bool> has_cell(survey_.parts().size(), false);
    for (const LabelCell cell : delaunay_.finite_cell_handles())
        if (cell->info().label != 0)
            if (const auto part = part_of(cell->info()))
                has_cell[*part] = true;
    std::vector<std::uint32_t> missing;
    std::copy_if(parts.begin(), parts.end(), std::back_inserter(missing),
                 [&](std::uint32_t part) { return !has_cell[part]; });
    return missing;
}

LabelPieces::Pieces LabelPieces::find_pieces()
{
    std::vector<LabelCell> cells;
    for (const LabelCell cell : delaunay_.all_cell_handles())
    {
        cell->info().number = static_cast<std::uint32_t>(cells.size());
        cells.push_back(cell);
    }
    UnionFind sets(cells.size());
    for (const LabelCell cell : cells)
        for (int i = 0; i < 4; ++i)
            if (cell->neighbor(i)->info().label == cell->info().label)
                sets.unite(cell->info().number, cell->neighbor(i)->info().number);
    Pieces pieces;
    for (std::uint32_t i = 0; i < cells.size(); ++i)
    {
        const LabelCell cell = cells[i];
        cell->info().number = sets.find(i);
        Piece& piece = pieces[cell->info().number];
        piece.label = cell->info().label;
        if (delaunay_.is_infinite(cell))
        {
            piece.outer = true;
            continue;
        }
        const double volume = delaunay_.tetrahedron(cell).volume();
        piece.volume += volume;
        if (piece.label == 0)
            continue;
        if (const auto part = part_of(cell->info()))
            piece.volume_of_part[*part] += volume;
    }
    return pieces;
}

//! The piece that has most of each part.
std::map<std::uint32_t, std::uint32_t> LabelPieces::pieces_of_parts(const Pieces& pieces)
{
    std::map<std::uint32_t, std::pair<double, std::uint32_t>> best;
    for (const auto& [number, piece] : pieces)
        for (const auto& [part, volume] : piece.volume_of_part)
            best[part] = std::max(best[part], std::pair{volume, number});
    std::map<std::uint32_t, std::uint32_t> piece_of_part;
    for (const auto& [part, found] : best)
        piece_of_part[part] = found.second;
    return piece_of_part;
}

std::size_t LabelPieces::dissolve_crumbs()
{
    constexpr int kRounds = 4;
    std::size_t changes = 0;
    for (int round = 0; round < kRounds; ++round)
    {
        const std::size_t changes_now = dissolve_once();
        changes += changes_now;
        if (changes_now == 0)
            break;
    }
    return changes;
}

std::size_t LabelPieces::dissolve_once()
{
    const Pieces pieces = find_pieces();
    std::set<std::uint32_t> needed;
    for (const auto& [part, number] : pieces_of_parts(pieces))
        needed.insert(number);
    const double voxel = spacing_.x * spacing_.y * spacing_.z;
    std::vector<std::pair<LabelCell, PartitionLabel>> relabelled;
    for (const LabelCell cell : delaunay_.finite_cell_handles())
    {
        const Piece& piece = pieces.at(cell->info().number);
        const bool wanted = piece.label == 0 ? piece.outer || piece.volume >= kLeastCavityInVoxels * voxel
                                             : needed.contains(cell->info().number) ||
                                                   piece.volume >= kLeastBitInVoxels * voxel;
        if (!wanted)
            relabelled.emplace_back(cell, label_around(cell));
    }
    std::size_t changes = 0;
    for (const auto& [cell, label] : relabelled)
    {
        changes += cell->info().label != label ? 1 : 0;
        cell->info().label = label;
    }
    return changes;
}

PartitionLabel LabelPieces::label_around(LabelCell cell)
{
    PartitionLabel best = cell->info().label;
    double most = 0.0;
    for (int i = 0; i < 4; ++i)
    {
        const std::array<Point3, 3> corner = facet_corners(cell, i);
        const double area = norm(cross(corner[1] - corner[0], corner[2] - corner[0]));
        if (cell->neighbor(i)->info().label != cell->info().label && area > most)
        {
            most = area;
            best = cell->neighbor(i)->info().label;
        }
    }
    return best;
}

LabelPieces::Faults LabelPieces::faults(std::span<const std::uint32_t> parts)
{
    const Pieces pieces = find_pieces();
    const std::map<std::uint32_t, std::uint32_t> piece_of_part = pieces_of_parts(pieces);
    std::map<std::uint32_t, std::uint32_t> largest_in; // part of each piece
    for (const auto& [part, number] : piece_of_part)
    {
        const auto [known, is_new] = largest_in.emplace(number, part);
        if (!is_new && survey_.parts()[part].voxels > survey_.parts()[known->second].voxels)
            known->second = part;
    }
    std::map<std::uint32_t, std::size_t> pieces_mostly_of; // part
    for (const auto& [number, piece] : pieces)
        if (!piece.volume_of_part.empty())
            ++pieces_mostly_of[std::max_element(piece.volume_of_part.begin(), piece.volume_of_part.end(),
                                                [](const auto& a, const auto& b)
                                                { return a.second < b.second; })
                                   ->first];
    Faults faults;
    for (const std::uint32_t part : parts)
    {
        const auto piece = piece_of_part.find(part);
        if (piece == piece_of_part.end())
            faults.missing.push_back(part);
        else if (largest_in.at(piece->second) != part)
            faults.merged.push_back(part);
        else if (pieces_mostly_of[part] > 1)
            faults.in_pieces.push_back(part);
    }
    return faults;
}

LabelPieces::PieceGraph LabelPieces::piece_graph()
{
    PieceGraph graph;
    std::map<std::uint32_t, std::uint32_t> place_of;
    for (auto& [number, piece] : find_pieces())
    {
        const auto place = static_cast<std::uint32_t>(graph.pieces.size());
        place_of.emplace(number, place);
        graph.outer = piece.outer ? place : graph.outer;
        graph.pieces.push_back(piece);
    }
    for (const LabelCell cell : delaunay_.all_cell_handles())
        for (int i = 0; i < 4; ++i)
            if (const std::uint32_t other = cell->neighbor(i)->info().number; cell->info().number < other)
                graph.contacts.emplace(place_of.at(cell->info().number), place_of.at(other));
    return graph;
}

std::vector<std::size_t> LabelPieces::count_cavities(const CavityLabels& apart)
{
    const PieceGraph graph = piece_graph();
    const auto stands_for = [&](std::uint32_t piece) { return apart.stands_for[graph.pieces[piece].label]; };
    const PartitionLabel last = *std::max_element(apart.stands_for.begin(), apart.stands_for.end());
    std::vector<std::size_t> count(last + 1, 0);
    std::set<PartitionLabel> labels_with_cavities;
    for (const auto& around : apart.cavities_around)
        for (const auto& [label, cavity] : around)
            labels_with_cavities.insert(label);
    for (const PartitionLabel label : labels_with_cavities)
    {
        UnionFind sets(graph.pieces.size());
        for (const auto& [a, b] : graph.contacts)
            if (stands_for(a) != label && stands_for(b) != label)
                sets.unite(a, b);
        // Volumes that each enclosed set has of each cavity: one set is one cavity, the one it has most of.
        std::map<std::uint32_t, std::map<std::uint32_t, double>> volume_in;
        for (std::uint32_t piece = 0; piece < graph.pieces.size(); ++piece)
        {
            const auto& around = apart.cavities_around[graph.pieces[piece].label];
            const auto cavity = around.find(label);
            if (cavity != around.end() && sets.find(piece) != sets.find(graph.outer))
                volume_in[sets.find(piece)][cavity->second] += graph.pieces[piece].volume;
        }
        std::set<std::uint32_t> found;
        for (const auto& [set, volumes] : volume_in)
            found.insert(std::max_element(volumes.begin(), volumes.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; })
                             ->first);
        count[label] = found.size();
    }
    return count;
}

} // namespace voroprobe
