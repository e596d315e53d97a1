// This file follows:
// Jean-Philippe Pons, Florent Segonne, Jean-Daniel Boissonnat, Laurent Rineau, Mariette Yvinec and Renaud
// Keriven, High-quality consistent meshing of multi-label datasets, IPMI 2007.

#include "labels/interface_meshing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "labels/label_delaunay.h"
#include "labels/label_pieces.h"
#include "mesh/circumcircle.h"
#include "mesh/measures.h"

namespace voroprobe
{
namespace
{

//! A facet to be refined, as long as its two cells are those it was found between: then its ball is empty,
//! and no two points come nearer than the floor.
struct BadFacet
{
    LabelCell cell;
    int index;
    std::uint64_t stamp;
    std::uint64_t stamp_of_other;
    Point3 center; //!< of its ball: the point to insert
};

double smallest_angle_deg(const std::array<Point3, 3>& corner)
{
    const auto angles = triangle_angles_deg(corner[0], corner[1], corner[2]);
    return *std::min_element(angles.begin(), angles.end());
}

//! A corner where the facet has no area.
Point3 circumcenter(const std::array<Point3, 3>& corner)
{
    const auto circle = circumcircle(corner[0], corner[1], corner[2]);
    return circle ? circle->center : corner[0];
}

class InterfaceMesher
{
public:
    InterfaceMesher(const LabelSurvey& survey, const CavityLabels& apart, const Vec3& spacing,
                    const LabelPartition& partition, const MeshingOptions& criteria, ProgressSink* progress)
        : map_(survey), apart_(apart), survey_(apart.survey), spacing_(spacing), partition_(partition),
          criteria_(criteria), progress_(progress), pieces_(delaunay_, survey_, spacing),
          parts_(survey_.parts().size())
    {
        std::iota(parts_.begin(), parts_.end(), 0);
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
            missing = pieces_.parts_without_cell(parts_);
        }
        InterfaceMesh mesh;
        mesh.crumbs_dissolved = pieces_.dissolve_crumbs();
        mesh.status = stopped_.value_or(MeshingStatus::kDone);
        extract(mesh);
        hold_against_map(mesh);
        return mesh;
    }

private:
    // Points on a part: the first time, and where it has no cell after refinement.
    static constexpr std::size_t kFirstPoints = 14;
    static constexpr std::size_t kMorePoints = 8;
    static constexpr std::size_t kMostPoints = 1000;

    //! Far enough that their Voronoi cells meet no label, near enough for exactness to come cheap.
    static constexpr double kSentinelDistance = 8.0;

    static constexpr std::size_t kInsertionsBetweenReports = 1024;

    void insert_sentinels()
    {
        const Box3 box = partition_.domain();
        const double far = kSentinelDistance * box.diagonal();
        for (const Vec3& direction : {Vec3{1, 1, 1}, Vec3{1, -1, -1}, Vec3{-1, 1, -1}, Vec3{-1, -1, 1}})
            delaunay_.insert(to_cgal(box.center() + far * direction))->info() = kSentinel;
        for (const LabelCell cell : delaunay_.finite_cell_handles())
            update(cell);
    }

    void update(LabelCell cell)
    {
        LabelledCellData& info = cell->info();
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
                if (!changes.empty() && !has_vertex_at(changes.front().point))
                    insert(changes.front().point);
            }
        }
    }

    //! Lines from both sides of an interface find the same point, but for rounding.
    [[nodiscard]] bool has_vertex_at(const Point3& p) const
    {
        constexpr double kSameInFloors = 0.01;
        const LabelVertex nearest = delaunay_.nearest_vertex(to_cgal(p), last_cell_);
        return distance(from_cgal(nearest->point()), p) < kSameInFloors * criteria_.floor_radius;
    }

    //! To the middles of the sides of a cube, and to its corners.
    static const std::vector<Vec3>& directions()
    {
        static const std::vector<Vec3> kAll = []
        {
            std::vector<Vec3> made;
            for (int x = -1; x <= 1; ++x)
                for (int y = -1; y <= 1; ++y)
                    for (int z = -1; z <= 1; ++z)
                        if (const int length = std::abs(x) + std::abs(y) + std::abs(z); length % 2 == 1)
                            made.push_back(normalized(Vec3{1.0 * x, 1.0 * y, 1.0 * z}));
            return made;
        }();
        return kAll;
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

    LabelVertex insert(const Point3& p, LabelCell hint = {})
    {
        const std::size_t before = delaunay_.number_of_vertices();
        const LabelVertex vertex = delaunay_.insert(to_cgal(p), hint == LabelCell() ? last_cell_ : hint);
        if (delaunay_.number_of_vertices() == before)
            return vertex; // there already
        vertex->info() = vertex_count_++;
        last_cell_ = vertex->cell();
        cells_.clear();
        delaunay_.incident_cells(vertex, std::back_inserter(cells_));
        for (const LabelCell cell : cells_)
            update(cell);
        // Facets within the star once each.
        for (const LabelCell cell : cells_)
            for (int i = 0; i < 4; ++i)
                if (cell->vertex(i) == vertex || cell->info().stamp < cell->neighbor(i)->info().stamp)
                    judge(cell, i);
        return vertex;
    }

    [[nodiscard]] static bool at_sentinel(LabelCell cell, int index)
    {
        for (int i = 1; i < 4; ++i)
            if (cell->vertex((index + i) % 4)->info() == kSentinel)
                return true;
        return false;
    }

    //! Puts the facet on the list of bad ones where it is one.
    void judge(LabelCell cell, int index)
    {
        const LabelCell other = cell->neighbor(index);
        if (delaunay_.is_infinite(cell) || delaunay_.is_infinite(other))
            return;
        partition_.find_changes({cell->info().circumcenter, other->info().circumcenter}, changes_);
        if (changes_.empty())
            return;
        const std::array<Point3, 3> corner = facet_corners(cell, index);
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
        return unresolved || smallest_angle_deg(corner) < criteria_.min_facet_angle_deg ||
               (criteria_.max_facet_distance &&
                distance(circumcenter(corner), center) > *criteria_.max_facet_distance);
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

    //! Vertices and faces.
    void extract(InterfaceMesh& mesh) const
    {
        mesh.vertices.resize(vertex_count_);
        for (const LabelVertex vertex : delaunay_.finite_vertex_handles())
            if (vertex->info() != kSentinel)
                mesh.vertices[vertex->info()] = from_cgal(vertex->point());
        for (const auto& facet : delaunay_.finite_facets())
        {
            // CGAL names the facet from the cell at the lower address: choose the side by label instead.
            const bool turned = facet.first->info().label > facet.first->neighbor(facet.second)->info().label;
            const auto [cell, index] = turned ? delaunay_.mirror_facet(facet) : facet;
            const PartitionLabel front = cell->info().label;
            const PartitionLabel behind = cell->neighbor(index)->info().label;
            if (front == behind || at_sentinel(cell, index))
                continue;
            InterfaceFace face{.vertices = {}, .front = front, .behind = behind};
            for (int i = 0; i < 3; ++i)
                face.vertices[static_cast<std::size_t>(i)] =
                    cell->vertex(LabelDelaunay::vertex_triple_index(index, i))->info();
            std::rotate(face.vertices.begin(), std::min_element(face.vertices.begin(), face.vertices.end()),
                        face.vertices.end());
            mesh.faces.push_back(face);
        }
        std::sort(mesh.faces.begin(), mesh.faces.end(),
                  [](const InterfaceFace& a, const InterfaceFace& b) { return a.vertices < b.vertices; });
    }

    void hold_against_map(InterfaceMesh& mesh)
    {
        std::set<std::uint32_t> missing;
        for (const std::uint32_t part : pieces_.faults(parts_).missing)
            if (stands_for(part) != 0)
                missing.insert(part_in_map(survey_.parts()[part].first_voxel));
        mesh.cavities = pieces_.count_cavities(apart_);

        // From here on by the labels of the label map.
        for (const LabelCell cell : delaunay_.all_cell_handles())
            cell->info().label = apart_.stands_for[cell->info().label];
        std::set<std::uint32_t> parts_of_map;
        for (const std::uint32_t part : parts_)
            if (stands_for(part) != 0)
                parts_of_map.insert(part_in_map(survey_.parts()[part].first_voxel));
        LabelPieces pieces(delaunay_, map_, spacing_);
        LabelPieces::Faults faults =
            pieces.faults(std::vector<std::uint32_t>(parts_of_map.begin(), parts_of_map.end()));
        mesh.missing_parts.assign(missing.begin(), missing.end());
        mesh.merged_parts = std::move(faults.merged);
        mesh.parts_in_pieces = std::move(faults.in_pieces);
    }

    //! A part of survey_.
    [[nodiscard]] PartitionLabel stands_for(std::uint32_t part) const
    {
        return apart_.stands_for[survey_.parts()[part].label + 1];
    }

    //! \pre there is one.
    [[nodiscard]] std::uint32_t part_in_map(const SampleIndex& voxel) const
    {
        const auto row = map_.row(voxel[1], voxel[2]);
        return std::find_if(row.begin(), row.end(), [&](const LabelRun& run) { return voxel[0] < run.end; })
            ->part;
    }

    const LabelSurvey& map_;
    const CavityLabels& apart_;
    const LabelSurvey& survey_; //!< of apart_
    Vec3 spacing_;
    const LabelPartition& partition_;
    const MeshingOptions& criteria_;
    ProgressSink* progress_;

    LabelDelaunay delaunay_;
    LabelPieces pieces_;
    std::vector<std::uint32_t> parts_; //!< all of survey_
    LabelCell last_cell_;
    std::uint32_t vertex_count_ = 0; //!< without sentinels
    std::uint64_t stamps_ = 0;
    std::vector<BadFacet> bad_facets_;
    std::size_t next_report_ = 0;
    std::optional<MeshingStatus> stopped_ = std::nullopt; //!< why, before the work was done
    std::vector<LabelCell> cells_;                        //!< scratch
    std::vector<LabelPartition::Change> changes_;         //!< scratch
};

} // namespace

InterfaceMesh mesh_interfaces(const LabelSurvey& survey, const CavityLabels& apart, const Vec3& spacing,
                              const LabelPartition& partition, const MeshingOptions& criteria,
                              ProgressSink* progress)
{
    return InterfaceMesher(survey, apart, spacing, partition, criteria, progress).run();
}

void name_labels_of_map(InterfaceMesh& interfaces, const CavityLabels& apart)
{
    for (InterfaceFace& face : interfaces.faces)
    {
        face.front = apart.stands_for[face.front];
        face.behind = apart.stands_for[face.behind];
    }
    std::erase_if(interfaces.faces, [](const InterfaceFace& face) { return face.front == face.behind; });
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
