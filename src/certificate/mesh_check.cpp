#include "certificate/mesh_check.h"

#include <algorithm>

#include <tbb/parallel_invoke.h>

#include "certificate/complaints.h"

namespace voroprobe
{

namespace
{

std::size_t count_duplicate_faces(const TriangleMesh& mesh)
{
    std::vector<TriangleMesh::Face> sorted = mesh.faces;
    for (TriangleMesh::Face& face : sorted)
        std::sort(face.begin(), face.end());
    std::sort(sorted.begin(), sorted.end());
    return static_cast<std::size_t>(sorted.end() - std::unique(sorted.begin(), sorted.end()));
}

void measure_angles(const TriangleMesh& mesh, std::optional<double> angle_bound_deg, MeshCheck& check)
{
    check.angles = measure_angles(mesh);
    for (std::size_t i = 0; i < kShownAnglesDeg.size(); ++i)
        check.faces_below_shown_angle[i] = count_faces_below_angle(mesh, kShownAnglesDeg[i]);
    if (angle_bound_deg)
        check.faces_below_angle_bound = count_faces_below_angle(mesh, *angle_bound_deg);
}

} // namespace

MeshCheck check_mesh(const TriangleMesh& mesh, std::optional<double> angle_bound_deg)
{
    MeshCheck check;
    check.vertices = mesh.vertices.size();
    check.faces = mesh.faces.size();
    tbb::parallel_invoke([&] { check.self_intersections = self_intersections(mesh); },
                         [&] { check.topology = analyze_topology(mesh); },
                         [&] { check.pieces = split_into_pieces(mesh).pieces; },
                         [&] { measure_angles(mesh, angle_bound_deg, check); },
                         [&] { check.duplicate_faces = count_duplicate_faces(mesh); });
    check.flat_faces = take_flat_faces(check.self_intersections);
    check.area = area(mesh);
    check.enclosed_volume = enclosed_volume(mesh);
    check.box = bounding_box(mesh);
    return check;
}

MeshCheck check_objects(std::span<const MeshPart> objects, std::optional<double> angle_bound_deg)
{
    MeshCheck check = check_mesh(merged(objects), angle_bound_deg);
    std::vector<std::size_t> faces_in_objects;
    for (const MeshPart& object : objects)
        faces_in_objects.push_back(object.mesh.faces.size());
    check.object_overlaps = take_object_overlaps(check.self_intersections, faces_in_objects);
    return check;
}

std::optional<std::string> defects(const MeshCheck& check)
{
    const MeshTopology& topology = check.topology;
    Complaints complaints;
    complaints.add(topology.boundary_edges, "edge on one face only", "edges on one face only");
    complaints.add_crowding(topology);
    complaints.add(check.flat_faces, "face without area", "faces without area");
    complaints.add(check.self_intersections.size(), "pair of faces that cross or overlap",
                   "pairs of faces that cross or overlap");
    if (!complaints.text() && check.enclosed_volume <= 0.0)
        return "faces that wind inward";
    return complaints.text();
}

} // namespace voroprobe
