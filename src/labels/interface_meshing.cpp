// This file follows:
// Jean-Philippe Pons, Florent Segonne, Jean-Daniel Boissonnat, Laurent Rineau, Mariette Yvinec and Renaud
// Keriven, High-quality consistent meshing of multi-label datasets, IPMI 2007.

#include "labels/interface_meshing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "support/union_find.h"

namespace voroprobe
{
namespace
{

//! What is known of a Delaunay cell.
struct CellInfo
{
    Point3 circumcenter;
    PartitionLabel label = 0;
    std::uint64_t stamp = 0; //!< of its making: cells are made anew in old places
    std::uint32_t number = 0;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using CellBase = CGAL::Triangulation_cell_base_with_info_3<CellInfo, Kernel,
                                                           CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using CellHandle = Delaunay::Cell_handle;
using VertexHandle = Delaunay::Vertex_handle;

constexpr std::uint32_t kSentinel = 0xFFFFFFFF;

Point3 from_cgal(const Kernel::Point_3& p)
{
    return {p.x(), p.y(), p.z()};
}

Kernel::Point_3 to_cgal(const Point3& p)
{
    return {p.x, p.y, p.z};
}

//! A facet to be refined, as long as its two cells are those it was found between: then its ball is empty,
//! and no two points come nearer than the floor.
struct BadFacet
{
    CellHandle cell;
    int index;
    std::uint64_t stamp;
    std::uint64_t stamp_of_other;
    Point3 center; //!< of its ball: the point to insert
};

Point3 circumcenter_of_triangle(const std::array<Point3, 3>& corner)
{
    const Vec3 a = corner[1] - corner[0];
    const Vec3 b = corner[2] - corner[0];
    const Vec3 n = cross(a, b);
    const double squared = dot(n, n);
    return squared > 0.0 ? corner[0] + (dot(b, b) * cross(n, a) + dot(a, a) * cross(b, n)) / (2.0 * squared)
                         : corner[0];
}

double smallest_angle(const std::array<Point3, 3>& corner)
{
    double cosine = -1.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const Vec3 a = corner[(i + 1) % 3] - corner[i];
        const Vec3 b = corner[(i + 2) % 3] - corner[i];
        cosine = std::max(cosine, dot(a, b) / (norm(a) * norm(b)));
    }
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

class InterfaceMesher
{
public:
    InterfaceMesher(const LabelSurvey& survey, std::span<const std::uint32_t> labels, const Vec3& spacing,
                    const LabelPartition& partition, const MeshingOptions& criteria, ProgressSink* progress)
        : survey_(survey), spacing_(spacing), partition_(partition), criteria_(criteria), progress_(progress)
    {
        for (const std::uint32_t label : labels)
            parts_.insert(parts_.end(), survey.labels()[label].parts.begin(),
                          survey.labels()[label].parts.end());
        std::sort(parts_.begin(), parts_.end());
    }

    InterfaceMesh run()
    {
        insert_sentinels();
        std::vector<std::uint32_t> missing = parts_;
        for (std::size_t points = kFirstPoints; !missing.empty() && points <= kMostPoints;
             points *= kMorePoints)
        {
            for (const std::uint32_t part : missing)
                insert_points_on(part, points);
            refine();
            if (stopped_)
                break;
            missing = parts_without_cell();
        }
        dissolve_crumbs();
        InterfaceMesh mesh = extract();
        judge_parts(mesh);
        return mesh;
    }

private:
    // Points on a part: the first time, and where it has no cell after refinement.
    static constexpr std::size_t kFirstPoints = 14;
    static constexpr std::size_t kMorePoints = 8;
    static constexpr std::size_t kMostPoints = 1000;

    //! Smaller bits of background are slivers: cavities of one voxel are larger.
    static constexpr double kLeastCavityInVoxels = 0.05;

    //! Far enough that their Voronoi cells meet no label, near enough for exactness to come cheap.
    static constexpr double kSentinelDistance = 8.0;

    static constexpr std::size_t kInsertionsBetweenReports = 1024;

    void insert_sentinels()
    {
        const Box3 box = partition_.domain();
        const double far = kSentinelDistance * box.diagonal();
        for (const Vec3& direction : {Vec3{1, 1, 1}, Vec3{1, -1, -1}, Vec3{-1, 1, -1}, Vec3{-1, -1, 1}})
            delaunay_.insert(to_cgal(box.center() + far * direction))->info() = kSentinel;
        for (const CellHandle cell : delaunay_.finite_cell_handles())
            update(cell);
    }

    void update(CellHandle cell)
    {
        CellInfo& info = cell->info();
        info.stamp = ++stamps_;
        info.label = 0;
        if (delaunay_.is_infinite(cell))
            return;
        info.circumcenter = from_cgal(delaunay_.dual(cell));
        info.label = partition_.label(info.circumcenter);
    }

    //! Points where the label of a part ends, on lines from the centers of some of its voxels.
    void insert_points_on(std::uint32_t place, std::size_t count)
    {
        const LabelPart& part = survey_.parts()[place];
        const std::vector<SampleIndex> voxels = spread_voxels(place, std::max<std::size_t>(1, count / 14));
        std::vector<LabelPartition::Change> changes;
        const double reach = norm(Vec3{spacing_.x * (part.box.last[0] - part.box.first[0] + 2),
                                       spacing_.y * (part.box.last[1] - part.box.first[1] + 2),
                                       spacing_.z * (part.box.last[2] - part.box.first[2] + 2)});
        for (const SampleIndex& voxel : voxels)
        {
            const Point3 center = partition_.center(voxel);
            if (partition_.label(center) != part.label + 1)
                continue;
            for (const Vec3& direction : directions())
            {
                partition_.find_changes({center, center + reach * direction}, changes);
                if (!changes.empty())
                    insert(changes.front().point);
            }
        }
    }

    //! To the middles of the sides of a cube, and to its corners.
    static const std::vector<Vec3>& directions()
    {
        static const std::vector<Vec3> all = []
        {
            std::vector<Vec3> made;
            for (int x = -1; x <= 1; ++x)
                for (int y = -1; y <= 1; ++y)
                    for (int z = -1; z <= 1; ++z)
                        if (const int length = std::abs(x) + std::abs(y) + std::abs(z); length % 2 == 1)
                            made.push_back(normalized(Vec3{1.0 * x, 1.0 * y, 1.0 * z}));
            return made;
        }();
        return all;
    }

    [[nodiscard]] std::vector<SampleIndex> spread_voxels(std::uint32_t place, std::size_t count) const
    {
        const LabelPart& part = survey_.parts()[place];
        const std::size_t step = std::max<std::size_t>(1, part.voxels / count);
        std::vector<SampleIndex> voxels;
        std::size_t seen = step / 2; // the first is the one in the middle where there is to be one
        for (int k = part.box.first[2]; k <= part.box.last[2]; ++k)
            for (int j = part.box.first[1]; j <= part.box.last[1]; ++j)
                for (const LabelRun& run : survey_.row(j, k))
                    for (int i = run.first; run.part == place && i < run.end; ++i)
                        if (++seen % step == 0)
                            voxels.push_back({i, j, k});
        return voxels;
    }

    VertexHandle insert(const Point3& p, CellHandle hint = {})
    {
        const std::size_t before = delaunay_.number_of_vertices();
        const VertexHandle vertex = delaunay_.insert(to_cgal(p), hint == CellHandle() ? last_cell_ : hint);
        if (delaunay_.number_of_vertices() == before)
            return vertex; // there already
        vertex->info() = vertex_count_++;
        last_cell_ = vertex->cell();
        cells_.clear();
        delaunay_.incident_cells(vertex, std::back_inserter(cells_));
        for (const CellHandle cell : cells_)
            update(cell);
        for (const CellHandle cell : cells_)
            for (int i = 0; i < 4; ++i)
                if (cell->vertex(i) == vertex || cell < cell->neighbor(i)) // facets within the star once
                    judge(cell, i);
        return vertex;
    }

    [[nodiscard]] static std::array<Point3, 3> corners(CellHandle cell, int index)
    {
        return {from_cgal(cell->vertex((index + 1) % 4)->point()),
                from_cgal(cell->vertex((index + 2) % 4)->point()),
                from_cgal(cell->vertex((index + 3) % 4)->point())};
    }

    [[nodiscard]] static bool at_sentinel(CellHandle cell, int index)
    {
        for (int i = 1; i < 4; ++i)
            if (cell->vertex((index + i) % 4)->info() == kSentinel)
                return true;
        return false;
    }

    //! Puts the facet on the list of bad ones where it is one.
    void judge(CellHandle cell, int index)
    {
        const CellHandle other = cell->neighbor(index);
        if (delaunay_.is_infinite(cell) || delaunay_.is_infinite(other))
            return;
        partition_.find_changes({cell->info().circumcenter, other->info().circumcenter}, changes_);
        if (changes_.empty())
            return;
        const std::array<Point3, 3> corner = corners(cell, index);
        // Of several changes the one farthest from the vertices: points far apart make few of them.
        const auto center = std::max_element(changes_.begin(), changes_.end(),
                                             [&](const auto& a, const auto& b) {
                                                 return squared_distance(a.point, corner[0]) <
                                                        squared_distance(b.point, corner[0]);
                                             })
                                ->point;
        if (is_bad(center, corner, at_sentinel(cell, index), changes_.size() > 1))
            bad_facets_.push_back({cell, index, cell->info().stamp, other->info().stamp, center});
    }

    [[nodiscard]] bool is_bad(const Point3& center, const std::array<Point3, 3>& corner, bool has_sentinel,
                              bool unresolved) const
    {
        const double radius = distance(center, corner[0]);
        if (has_sentinel || radius > criteria_.max_facet_radius)
            return true;
        if (radius <= criteria_.floor_radius)
            return false;
        return unresolved || smallest_angle(corner) < criteria_.min_facet_angle_deg ||
               (criteria_.max_facet_distance &&
                distance(circumcenter_of_triangle(corner), center) > *criteria_.max_facet_distance);
    }

    void refine()
    {
        while (!bad_facets_.empty() && !stopped_)
        {
            const BadFacet bad = bad_facets_.back();
            bad_facets_.pop_back();
            if (!delaunay_.tds().cells().is_used(bad.cell) || bad.cell->info().stamp != bad.stamp ||
                bad.cell->neighbor(bad.index)->info().stamp != bad.stamp_of_other)
                continue;
            if (criteria_.max_vertices && vertex_count_ >= *criteria_.max_vertices)
            {
                stopped_ = MeshingStatus::kBudgetExhausted;
                return;
            }
            insert(bad.center, bad.cell);
            report();
        }
    }

    void report()
    {
        if (progress_ == nullptr || vertex_count_ < next_report_)
            return;
        next_report_ = vertex_count_ + kInsertionsBetweenReports;
        progress_->report(
            {.phase = "refinement", .vertices = vertex_count_, .bad_facets_left = bad_facets_.size()});
        if (progress_->stop_requested())
            stopped_ = MeshingStatus::kInterrupted;
    }

    //! The part of the cell's label that has the voxel nearest to its circumcenter, among the voxels around
    //! it.
    [[nodiscard]] std::optional<std::uint32_t> part_at(const CellInfo& cell) const
    {
        const Vec3 index{cell.circumcenter.x / spacing_.x, cell.circumcenter.y / spacing_.y,
                         cell.circumcenter.z / spacing_.z};
        std::optional<std::uint32_t> part;
        double nearest = 0.0;
        const auto from = [&](std::size_t axis) { return static_cast<int>(std::floor(index[axis])) - 1; };
        for (int k = from(2); k < from(2) + 4; ++k)
            for (int j = from(1); j < from(1) + 4; ++j)
                for (const LabelRun& run : survey_.row(j, k))
                {
                    if (survey_.parts()[run.part].label + 1 != cell.label || run.end <= from(0) ||
                        run.first >= from(0) + 4)
                        continue;
                    const int i = std::clamp(static_cast<int>(std::lround(index.x)), run.first, run.end - 1);
                    const double d = squared_distance(partition_.center({i, j, k}), cell.circumcenter);
                    if (!part || d < nearest)
                    {
                        part = run.part;
                        nearest = d;
                    }
                }
        return part;
    }

    [[nodiscard]] std::vector<std::uint32_t> parts_without_cell() const
    {
        std::vector<bool> has_cell(survey_.parts().size(), false);
        for (const CellHandle cell : delaunay_.finite_cell_handles())
            if (cell->info().label != 0)
                if (const auto part = part_at(cell->info()))
                    has_cell[*part] = true;
        std::vector<std::uint32_t> missing;
        std::copy_if(parts_.begin(), parts_.end(), std::back_inserter(missing),
                     [&](std::uint32_t part) { return !has_cell[part]; });
        return missing;
    }

    //! Parts that have no piece, and parts whose piece is that of a larger one.
    void judge_parts(InterfaceMesh& mesh)
    {
        const std::map<std::uint32_t, std::uint32_t> piece_of_part = pieces_of_parts(find_pieces());
        std::map<std::uint32_t, std::uint32_t> largest_in; // part of each piece
        for (const auto& [part, number] : piece_of_part)
        {
            const auto [known, is_new] = largest_in.emplace(number, part);
            if (is_new)
                continue;
            if (survey_.parts()[part].voxels > survey_.parts()[known->second].voxels)
                known->second = part;
        }
        for (const std::uint32_t part : parts_)
        {
            const auto piece = piece_of_part.find(part);
            if (piece == piece_of_part.end())
                mesh.missing_parts.push_back(part);
            else if (largest_in.at(piece->second) != part)
                mesh.merged_parts.push_back(part);
        }
    }

    //! Delaunay cells of one label that are joined through facets.
    struct Piece
    {
        double volume = 0.0;
        PartitionLabel label = 0;
        bool outer = false;                             //!< it reaches to infinity
        std::map<std::uint32_t, double> volume_of_part; //!< by place
    };

    //! By the number that their cells then have.
    std::map<std::uint32_t, Piece> find_pieces()
    {
        std::vector<CellHandle> cells;
        for (const CellHandle cell : delaunay_.all_cell_handles())
        {
            cell->info().number = static_cast<std::uint32_t>(cells.size());
            cells.push_back(cell);
        }
        UnionFind sets(cells.size());
        for (const CellHandle cell : cells)
            for (int i = 0; i < 4; ++i)
                if (cell->neighbor(i)->info().label == cell->info().label)
                    sets.unite(cell->info().number, cell->neighbor(i)->info().number);
        std::map<std::uint32_t, Piece> pieces;
        for (std::uint32_t i = 0; i < cells.size(); ++i)
        {
            const CellHandle cell = cells[i];
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
            if (const auto part = part_at(cell->info()))
                piece.volume_of_part[*part] += volume;
        }
        return pieces;
    }

    //! The piece that has most of each part.
    static std::map<std::uint32_t, std::uint32_t>
    pieces_of_parts(const std::map<std::uint32_t, Piece>& pieces)
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

    //! Slivers make pieces of a label that none of its parts needs: all but the largest piece of each part,
    //! and bits of background. Their cells get the label around them that they share the largest facet with.
    void dissolve_crumbs()
    {
        constexpr int kRounds = 4;
        for (int round = 0; round < kRounds && dissolve_once(); ++round)
            continue;
    }

    bool dissolve_once()
    {
        const std::map<std::uint32_t, Piece> pieces = find_pieces();
        std::set<std::uint32_t> needed;
        for (const auto& [part, number] : pieces_of_parts(pieces))
            needed.insert(number);
        const double least_of_background = kLeastCavityInVoxels * spacing_.x * spacing_.y * spacing_.z;
        std::vector<std::pair<CellHandle, PartitionLabel>> relabelled;
        for (const CellHandle cell : delaunay_.finite_cell_handles())
        {
            const Piece& piece = pieces.at(cell->info().number);
            const bool wanted = piece.label == 0 ? piece.outer || piece.volume >= least_of_background
                                                 : needed.contains(cell->info().number);
            if (!wanted)
                relabelled.emplace_back(cell, label_around(cell));
        }
        bool changed = false;
        for (const auto& [cell, label] : relabelled)
        {
            crumbs_ += cell->info().label != label ? 1 : 0;
            changed = changed || cell->info().label != label;
            cell->info().label = label;
        }
        return changed;
    }

    [[nodiscard]] PartitionLabel label_around(CellHandle cell) const
    {
        PartitionLabel best = cell->info().label;
        double most = 0.0;
        for (int i = 0; i < 4; ++i)
        {
            const std::array<Point3, 3> corner = corners(cell, i);
            const double area = norm(cross(corner[1] - corner[0], corner[2] - corner[0]));
            if (cell->neighbor(i)->info().label != cell->info().label && area > most)
            {
                most = area;
                best = cell->neighbor(i)->info().label;
            }
        }
        return best;
    }

    InterfaceMesh extract() const
    {
        InterfaceMesh mesh{.vertices = {},
                           .faces = {},
                           .missing_parts = {},
                           .merged_parts = {},
                           .crumbs_dissolved = crumbs_,
                           .status = stopped_.value_or(MeshingStatus::kDone)};
        mesh.vertices.resize(vertex_count_);
        for (const VertexHandle vertex : delaunay_.finite_vertex_handles())
            if (vertex->info() != kSentinel)
                mesh.vertices[vertex->info()] = from_cgal(vertex->point());
        for (const auto& facet : delaunay_.finite_facets())
        {
            const CellHandle cell = facet.first;
            const CellHandle other = cell->neighbor(facet.second);
            if (cell->info().label == other->info().label || at_sentinel(cell, facet.second))
                continue;
            InterfaceFace face{.vertices = {}, .front = cell->info().label, .behind = other->info().label};
            for (int i = 0; i < 3; ++i)
                face.vertices[static_cast<std::size_t>(i)] =
                    cell->vertex(Delaunay::vertex_triple_index(facet.second, i))->info();
            mesh.faces.push_back(face);
        }
        std::sort(mesh.faces.begin(), mesh.faces.end(),
                  [](const InterfaceFace& a, const InterfaceFace& b) { return a.vertices < b.vertices; });
        return mesh;
    }

    const LabelSurvey& survey_;
    Vec3 spacing_;
    const LabelPartition& partition_;
    const MeshingOptions& criteria_;
    ProgressSink* progress_;
    std::vector<std::uint32_t> parts_; //!< of the labels asked for

    Delaunay delaunay_;
    CellHandle last_cell_;
    std::uint32_t vertex_count_ = 0; //!< without sentinels
    std::uint64_t stamps_ = 0;
    std::vector<BadFacet> bad_facets_;
    std::size_t crumbs_ = 0;
    std::size_t next_report_ = 0;
    std::optional<MeshingStatus> stopped_ = std::nullopt; //!< why, before the work was done
    std::vector<CellHandle> cells_;                       //!< scratch
    std::vector<LabelPartition::Change> changes_;         //!< scratch
};

} // namespace

InterfaceMesh mesh_interfaces(const LabelSurvey& survey, std::span<const std::uint32_t> labels,
                              const Vec3& spacing, const LabelPartition& partition,
                              const MeshingOptions& criteria, ProgressSink* progress)
{
    return InterfaceMesher(survey, labels, spacing, partition, criteria, progress).run();
}

TriangleMesh mesh_of_label(const InterfaceMesh& interfaces, PartitionLabel label)
{
    TriangleMesh mesh;
    std::vector<std::uint32_t> place_of(interfaces.vertices.size(), kSentinel);
    for (const InterfaceFace& face : interfaces.faces)
    {
        if (face.front != label && face.behind != label)
            continue;
        TriangleMesh::Face turned = face.vertices; // outward of what is behind
        if (face.front == label)
            std::swap(turned[1], turned[2]);
        for (std::uint32_t& v : turned)
        {
            if (place_of[v] == kSentinel)
            {
                place_of[v] = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(interfaces.vertices[v]);
            }
            v = place_of[v];
        }
        mesh.faces.push_back(turned);
    }
    return mesh;
}

} // namespace voroprobe
