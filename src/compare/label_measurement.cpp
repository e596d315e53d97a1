#include "compare/label_measurement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "compare/label_frame.h"
#include "compare/measurement.h"
#include "labels/part_presence.h"
#include "mesh/measures.h"
#include "mesh/topology.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

//! Labels beyond such a change of volume are counted, as a fraction.
constexpr double kLargeChange = 0.02;

//! Small labels get so many samples all the same.
constexpr std::size_t kFewestSamples = 50;

void append(TriangleMesh& mesh, const TriangleMesh& more)
{
    const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const TriangleMesh::Face& face : more.faces)
        mesh.faces.push_back({face[0] + offset, face[1] + offset, face[2] + offset});
}

//! Side by side: no vertex is shared, so that neighbours do not hang together.
TriangleMesh together(const std::vector<TriangleMesh>& meshes)
{
    TriangleMesh all;
    for (const TriangleMesh& mesh : meshes)
        append(all, mesh);
    return all;
}

AffineTransform mask_from_grid(const LabelTask& task, const PartMask& mask)
{
    return inverse(grid_from_mask(task, mask));
}

TriangleMesh in_mask_frame(const TriangleMesh& mesh, const LabelTask& task, const PartMask& mask)
{
    TriangleMesh moved = mesh;
    transform(moved, mask_from_grid(task, mask));
    return moved;
}

//! Distances of several meshes, as those of one: samples are spread evenly over the area of all.
void add(const DirectedDistance& one, const AffineTransform& grid_from_one, DirectedDistance& all)
{
    all.samples += one.samples;
    if (one.max >= all.max)
    {
        all.max = one.max;
        all.max_at = grid_from_one * one.max_at;
    }
    all.spread.insert(all.spread.end(), one.spread.begin(), one.spread.end());
}

void take_averages(DirectedDistance& distance)
{
    if (distance.spread.empty())
        return;
    double sum = 0.0;
    double sum_of_squares = 0.0;
    for (const double d : distance.spread)
    {
        sum += d;
        sum_of_squares += d * d;
    }
    const auto count = static_cast<double>(distance.spread.size());
    distance.mean = sum / count;
    distance.root_mean_square = std::sqrt(sum_of_squares / count);
    std::sort(distance.spread.begin(), distance.spread.end());
    distance.percentile_95 = distance.spread[static_cast<std::size_t>(0.95 * (count - 1.0))];
}

class LabelMeasuring
{
public:
    LabelMeasuring(const std::vector<TriangleMesh>& meshes, const LabelTask& task,
                   const MeasuringOptions& options)
        : meshes_(meshes), task_(task), options_(options), all_(together(meshes)), area_(area(all_))
    {
    }

    Json run()
    {
        total_.shapes = measure_shapes(all_);
        measure_whole();
        for (std::size_t i = 0; i < meshes_.size(); ++i)
            measure_label(meshes_[i], task_.labels[i]);
        take_averages(total_.certificate.distance.from_mesh);
        take_averages(total_.certificate.distance.from_surface);
        const ReferenceSurface frame{.oracle = nullptr,
                                     .inventory = nullptr,
                                     .world_from_grid = task_.world_from_grid,
                                     .voxel = task_.voxel};
        Json json = to_json(total_, frame);
        json["labels"] = labels_json();
        return json;
    }

private:
    //! What does not depend on which label a face belongs to.
    void measure_whole()
    {
        MeshCheck& check = total_.check;
        check.vertices = all_.vertices.size();
        check.faces = all_.faces.size();
        check.topology = analyze_topology(all_);
        check.pieces = split_into_pieces(all_).pieces;
        check.angles = measure_angles(all_);
        for (std::size_t i = 0; i < kShownAnglesDeg.size(); ++i)
            check.faces_below_shown_angle[i] = count_faces_below_angle(all_, kShownAnglesDeg[i]);
        check.area = area_;
        check.enclosed_volume = enclosed_volume(all_);
    }

    void measure_label(const TriangleMesh& mesh, std::uint32_t label)
    {
        const PartMask mask = mask_of_label(task_, label);
        const TriangleMesh moved = in_mask_frame(mesh, task_, mask);
        list_missing(parts_present(moved, mask, task_.spacing), label);
        take_volume(enclosed_volume(mesh), label);
        not_closed_manifold_ += mesh.faces.empty() || !is_closed_manifold(mesh) ? 1 : 0;
        if (mesh.faces.empty())
            return;
        count_crossings(mesh);
        measure_distance(moved, mask);
    }

    void list_missing(const std::vector<bool>& present, std::uint32_t label)
    {
        const std::vector<std::uint32_t>& parts = task_.survey->labels()[label].parts;
        Certificate& certificate = total_.certificate;
        certificate.surfaces_expected += parts.size();
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (present[i])
                ++certificate.surfaces_meshed;
            else
                certificate.missing.push_back({static_cast<SurfaceId>(parts[i]),
                                               task_.survey->parts()[parts[i]].voxels, grid_box(parts[i]),
                                               "no closed piece of the mesh has most of its corners there"});
    }

    [[nodiscard]] Box3 grid_box(std::uint32_t part) const
    {
        const IndexBox& box = task_.survey->parts()[part].box;
        Box3 grid;
        for (const SampleIndex& corner : {box.first, box.last})
            grid.include(
                {task_.spacing.x * corner[0], task_.spacing.y * corner[1], task_.spacing.z * corner[2]});
        return grid;
    }

    void take_volume(double volume, std::uint32_t label)
    {
        const double voxels = task_.spacing.x * task_.spacing.y * task_.spacing.z *
                              static_cast<double>(task_.survey->labels()[label].voxels);
        const double change = std::abs(volume / voxels - 1.0);
        total_.certificate.surfaces_inside_out += volume < 0.0 ? 1 : 0;
        sum_of_changes_ += change;
        largest_change_ = std::max(largest_change_, change);
        beyond_large_change_ += change > kLargeChange ? 1 : 0;
    }

    void count_crossings(const TriangleMesh& mesh)
    {
        std::vector<FacePair> pairs = self_intersections(mesh);
        total_.check.flat_faces += take_flat_faces(pairs);
        total_.check.self_intersections.insert(total_.check.self_intersections.end(), pairs.begin(),
                                               pairs.end());
    }

    void measure_distance(const TriangleMesh& moved, const PartMask& mask)
    {
        const ReferenceSurface reference = halfway_surface(task_, mask);
        const auto share = static_cast<std::size_t>(static_cast<double>(options_.mesh_samples) * area(moved) /
                                                    std::max(area_, std::numeric_limits<double>::min()));
        const std::size_t samples = std::max(kFewestSamples, share);
        const SurfaceDistance distance = surface_distance(
            moved, *reference.oracle, {.mesh_samples = samples, .surface_samples = samples / 2});
        const AffineTransform to_grid = grid_from_mask(task_, mask);
        SurfaceDistance& all = total_.certificate.distance;
        add(distance.from_mesh, to_grid, all.from_mesh);
        add(distance.from_surface, to_grid, all.from_surface);
    }

    [[nodiscard]] Json labels_json() const
    {
        const auto count = static_cast<double>(std::max<std::size_t>(1, task_.labels.size()));
        return {{"count", task_.labels.size()},
                {"mean_volume_change", sum_of_changes_ / count},
                {"largest_volume_change", largest_change_},
                {"beyond_2_percent", beyond_large_change_},
                {"not_closed_manifold", not_closed_manifold_}};
    }

    const std::vector<TriangleMesh>& meshes_;
    const LabelTask& task_;
    const MeasuringOptions& options_;
    TriangleMesh all_;
    double area_;
    Measurement total_;
    double sum_of_changes_ = 0.0;
    double largest_change_ = 0.0;
    std::size_t beyond_large_change_ = 0;
    std::size_t not_closed_manifold_ = 0;
};

} // namespace

nlohmann::ordered_json measure_labels(const std::vector<TriangleMesh>& meshes, const LabelTask& task,
                                      const MeasuringOptions& options)
{
    return LabelMeasuring(meshes, task, options).run();
}

ViewMesh make_label_view(const std::vector<TriangleMesh>& meshes, const LabelTask& task,
                         std::size_t most_faces)
{
    std::size_t faces = 0;
    for (const TriangleMesh& mesh : meshes)
        faces += mesh.faces.size();
    const double share = std::min(1.0, static_cast<double>(most_faces) / static_cast<double>(faces));
    ViewMesh view;
    for (std::size_t i = 0; i < meshes.size(); ++i)
    {
        if (meshes[i].faces.empty())
            continue;
        const PartMask mask = mask_of_label(task, task.labels[i]);
        const auto most =
            static_cast<std::size_t>(std::ceil(share * static_cast<double>(meshes[i].faces.size())));
        const ViewMesh one =
            make_view_mesh(in_mask_frame(meshes[i], task, mask), halfway_surface(task, mask), most);
        append(view.mesh, one.mesh);
        view.smallest_angles_deg.insert(view.smallest_angles_deg.end(), one.smallest_angles_deg.begin(),
                                        one.smallest_angles_deg.end());
        view.distances.insert(view.distances.end(), one.distances.begin(), one.distances.end());
        view.pieces.insert(view.pieces.end(), one.mesh.faces.size(), static_cast<std::uint32_t>(i));
        view.faces_of_whole += one.faces_of_whole;
    }
    return view;
}

} // namespace voroprobe
