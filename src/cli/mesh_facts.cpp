#include "cli/mesh_facts.h"

namespace voroprobe
{

MeshFacts measure_mesh(const TriangleMesh& mesh, double angle_bound_deg,
                       const std::optional<MeshTopology>& topology)
{
    return {.vertices = mesh.vertices.size(),
            .faces = mesh.faces.size(),
            .topology = topology ? *topology : analyze_topology(mesh),
            .coincident_vertices = mesh.vertices.size() - weld(mesh).vertices.size(),
            .area_mm2 = area(mesh),
            .volume_mm3 = enclosed_volume(mesh),
            .angles = measure_angles(mesh),
            .faces_below_angle_bound = count_faces_below_angle(mesh, angle_bound_deg)};
}

} // namespace voroprobe
