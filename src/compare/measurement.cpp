#include "compare/measurement.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

//! Vertices of other people's meshes may lie so far from the surface they stand for, voxels: meshes are
//! smoothed and decimated.
constexpr double kReachInVoxels = 2.0;

//! Distances of the histogram, in voxels: meshes of scans are nearer than that.
constexpr double kLongestShownInVoxels = 0.5;
constexpr std::size_t kDistanceBins = 50;

SamplingOptions sampling(const MeasuringOptions& options)
{
    return {.mesh_samples = options.mesh_samples, .surface_samples = options.mesh_samples / 2};
}

Json json_of(const Histogram& histogram)
{
    return {{"low", histogram.low()}, {"high", histogram.high()}, {"counts", histogram.counts()}};
}

double share(std::size_t part, std::size_t whole)
{
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

Json angles_json(const MeshCheck& check)
{
    Json json = {{"min_deg", check.angles.min_deg},
                 {"mean_min_deg", check.angles.mean_min_deg},
                 {"max_deg", check.angles.max_deg}};
    for (std::size_t i = 0; i < kShownAnglesDeg.size(); ++i)
    {
        const std::string bound = std::to_string(static_cast<int>(kShownAnglesDeg[i]));
        json["faces_below_" + bound] = check.faces_below_shown_angle[i];
        json["share_below_" + bound] = share(check.faces_below_shown_angle[i], check.faces);
    }
    return json;
}

Json shapes_json(const ShapeMeasures& shapes)
{
    return {{"mean_radius_edge_ratio", shapes.mean_radius_edge_ratio},
            {"max_radius_edge_ratio", shapes.max_radius_edge_ratio},
            {"mean_aspect_ratio", shapes.mean_aspect_ratio},
            {"max_aspect_ratio", shapes.max_aspect_ratio},
            {"mean_edge_length_mm", shapes.mean_edge_length},
            {"vertices_by_valence", shapes.vertices_by_valence}};
}

//! Handles of the closed pieces; those of others are not defined.
long total_genus(const std::vector<MeshPiece>& pieces)
{
    long genus = 0;
    for (const MeshPiece& piece : pieces)
        genus += piece.closed() && piece.crowded_edges == 0 ? std::max(0L, piece.genus()) : 0;
    return genus;
}

Json topology_json(const Measurement& measurement)
{
    const MeshCheck& check = measurement.check;
    const MeshTopology& topology = check.topology;
    return {{"pieces", topology.components},
            {"closed", topology.closed()},
            {"manifold", topology.manifold()},
            {"oriented", topology.oriented() && measurement.certificate.surfaces_inside_out == 0},
            {"surfaces_inside_out", measurement.certificate.surfaces_inside_out},
            {"self_intersections", check.self_intersections.size()},
            {"flat_faces", check.flat_faces},
            {"boundary_edges", topology.boundary_edges},
            {"non_manifold_edges", topology.non_manifold_edges},
            {"non_manifold_vertices", topology.non_manifold_vertices},
            {"misoriented_edges", topology.misoriented_edges},
            {"euler_characteristic", topology.euler_characteristic},
            {"genus", total_genus(check.pieces)}};
}

Json missing_json(const MissingSurface& surface, const AffineTransform& world_from_grid)
{
    return {{"id", surface.id},
            {"voxels", surface.voxels},
            {"reason", surface.reason},
            {"center_mm", to_json(world_from_grid * surface.box.center())},
            {"size_mm", to_json(surface.box.extent())}};
}

Json surfaces_json(const Certificate& certificate, const AffineTransform& world_from_grid)
{
    Json missing = Json::array();
    for (const MissingSurface& surface : certificate.missing)
        missing.push_back(missing_json(surface, world_from_grid));
    Json split = Json::array();
    for (const SplitSurface& surface : certificate.split)
        split.push_back({{"id", surface.id}, {"pieces", surface.pieces}});
    Json handles = Json::array();
    for (const GenusMismatch& surface : certificate.genus_mismatches)
        handles.push_back({{"id", surface.id},
                           {"euler_characteristic", surface.mesh_euler_characteristic},
                           {"in_the_scan", surface.expected_euler_characteristic}});
    return {{"expected", certificate.surfaces_expected},
            {"meshed", certificate.surfaces_meshed},
            {"missing", missing},
            {"split", split},
            {"foreign_pieces", certificate.foreign.size()},
            {"genus_mismatches", handles}};
}

Json json_of(const DirectedDistance& distance, const AffineTransform& world_from_grid)
{
    return {{"max", distance.max},           {"max_at_mm", to_json(world_from_grid * distance.max_at)},
            {"mean", distance.mean},         {"rms", distance.root_mean_square},
            {"p95", distance.percentile_95}, {"samples", distance.samples}};
}

Json in_voxels(const TwoSidedDistance& distance, double voxel)
{
    return to_json(TwoSidedDistance{distance.max / voxel, distance.mean / voxel,
                                    distance.root_mean_square / voxel, distance.percentile_95 / voxel});
}

Json distance_json(const SurfaceDistance& distance, const ReferenceSurface& reference)
{
    const TwoSidedDistance both = two_sided(distance);
    return {{"mm", to_json(both)},
            {"voxels", in_voxels(both, reference.voxel)},
            {"from_mesh_mm", json_of(distance.from_mesh, reference.world_from_grid)},
            {"from_scan_mm", json_of(distance.from_surface, reference.world_from_grid)}};
}

Histogram distances(const SurfaceDistance& distance, double voxel)
{
    Histogram histogram(0.0, kLongestShownInVoxels, kDistanceBins);
    for (const DirectedDistance* direction : {&distance.from_mesh, &distance.from_surface})
        for (const double d : direction->spread)
            histogram.add(d / voxel);
    return histogram;
}

} // namespace

TwoSidedDistance two_sided(const SurfaceDistance& distance)
{
    const DirectedDistance& a = distance.from_mesh;
    const DirectedDistance& b = distance.from_surface;
    return {.max = distance.max(),
            .mean = distance.mean(),
            .root_mean_square = std::sqrt(
                0.5 * (a.root_mean_square * a.root_mean_square + b.root_mean_square * b.root_mean_square)),
            .percentile_95 = std::max(a.percentile_95, b.percentile_95)};
}

Measurement measure(const TriangleMesh& mesh, const ReferenceSurface& reference,
                    const MeasuringOptions& options)
{
    return {.check = check_mesh(mesh, options.angle_bound_deg),
            .shapes = measure_shapes(mesh),
            .certificate = certify(mesh, *reference.oracle, reference.inventory->surfaces(),
                                   {.reach = kReachInVoxels * reference.voxel,
                                    .sampling = sampling(options),
                                    .test_self_intersections = false})};
}

TwoSidedDistance measure_distance(const TriangleMesh& mesh, const ReferenceSurface& reference,
                                  const MeasuringOptions& options)
{
    std::vector<Point3> points;
    Box3 box;
    for (const ScanSurface& surface : reference.inventory->surfaces())
    {
        points.push_back(surface.point);
        box.include(surface.box.min);
        box.include(surface.box.max);
    }
    SamplingOptions samples = sampling(options);
    samples.box = box;
    return two_sided(surface_distance(mesh, *reference.oracle, samples, points));
}

nlohmann::ordered_json to_json(const Vec3& v)
{
    return Json::array({v.x, v.y, v.z});
}

nlohmann::ordered_json to_json(const TwoSidedDistance& distance)
{
    return {{"max", distance.max},
            {"mean", distance.mean},
            {"rms", distance.root_mean_square},
            {"p95", distance.percentile_95}};
}

nlohmann::ordered_json box_json(const Box3& box_grid, const AffineTransform& world_from_grid)
{
    Box3 box;
    for (unsigned corner = 0; corner < 8; ++corner)
        box.include(world_from_grid * Point3{corner & 1U ? box_grid.max.x : box_grid.min.x,
                                             corner & 2U ? box_grid.max.y : box_grid.min.y,
                                             corner & 4U ? box_grid.max.z : box_grid.min.z});
    return {{"min", to_json(box.min)}, {"max", to_json(box.max)}};
}

nlohmann::ordered_json to_json(const Measurement& measurement, const ReferenceSurface& reference)
{
    const MeshCheck& check = measurement.check;
    const Certificate& certificate = measurement.certificate;
    return {{"vertices", check.vertices},
            {"faces", check.faces},
            {"angles", angles_json(check)},
            {"shape", shapes_json(measurement.shapes)},
            {"area_mm2", check.area},
            {"volume_mm3", check.enclosed_volume},
            {"topology", topology_json(measurement)},
            {"surfaces", surfaces_json(certificate, reference.world_from_grid)},
            {"distance", distance_json(certificate.distance, reference)},
            {"histograms",
             {{"smallest_angles_deg", json_of(measurement.shapes.smallest_angles)},
              {"angles_deg", json_of(measurement.shapes.angles)},
              {"distance_voxels", json_of(distances(certificate.distance, reference.voxel))}}}};
}

} // namespace voroprobe
