#include "compare/contestant_list.h"

#include <algorithm>

namespace voroprobe
{

std::vector<ContestantEntry> all_contestants()
{
    return {
        {kOurs, "Voroprobe",
         "Delaunay refinement that begins every surface of the scan, with the criteria given.",
         Knob::kCriteria, make_voroprobe},
        {kReference, "Marching cubes",
         "VTK's FlyingEdges, the reference. The volume is padded, and the caps moved onto its border.",
         Knob::kNone, make_marching_cubes},
        {"decimated", "Marching cubes, decimated",
         "The same, then VTK's quadric decimation to Voroprobe's number of vertices.", Knob::kTargetVertices,
         make_decimated},
        {"smoothed", "Marching cubes, smoothed",
         "The same, then VTK's windowed-sinc smoothing as 3D Slicer does it (20 rounds, pass band 0.01).",
         Knob::kNone, make_smoothed},
        {"remeshed", "Marching cubes, remeshed",
         "The same, then CGAL's isotropic remeshing (3 rounds) to Voroprobe's mean edge length.",
         Knob::kTargetEdge, make_remeshed},
        {"openvdb", "OpenVDB",
         "volumeToMesh, dual contouring without adaptivity; quads cut along the shorter diagonal.",
         Knob::kNone, make_openvdb},
        {"surface_mesher_default", "CGAL make_surface_mesh",
         "Delaunay refinement with the same criteria, begun at CGAL's default points: 20 rays from the "
         "middle.",
         Knob::kCriteria,
         [](const MeshingTask& task) { return make_surface_mesher(task, FirstPoints::kDefault); }},
        {"surface_mesher", "CGAL make_surface_mesh, seeded",
         "The same with 20 first points more on every connected set of inside samples: CGAL has no search of "
         "its "
         "own for this mesher.",
         Knob::kCriteria,
         [](const MeshingTask& task) { return make_surface_mesher(task, FirstPoints::kSeeded); }},
        {"mesh_3", "CGAL make_mesh_3",
         "Delaunay refinement with the same criteria, begun at CGAL's default points; facet criteria only.",
         Knob::kCriteria, [](const MeshingTask& task) { return make_mesh_3(task, Mesh3Seeding::kDefault); }},
        {"mesh_3_scan", "CGAL make_mesh_3, image scan",
         "The same after CGAL's own search for components in the image.", Knob::kCriteria,
         [](const MeshingTask& task) { return make_mesh_3(task, Mesh3Seeding::kScan); }},
    };
}

MeshingTask coarser(const MeshingTask& task, Knob knob, double factor)
{
    MeshingTask result = task;
    switch (knob)
    {
    case Knob::kNone:
        break;
    case Knob::kCriteria:
        result.max_facet_radius *= factor;
        result.max_facet_distance *= factor;
        result.floor_radius *= std::min(factor, 1.0); // a coarser one would lose surfaces
        break;
    case Knob::kTargetVertices:
        result.target_vertices =
            static_cast<std::size_t>(static_cast<double>(task.target_vertices) / (factor * factor));
        break;
    case Knob::kTargetEdge:
        result.target_edge_length *= factor;
        break;
    }
    return result;
}

} // namespace voroprobe
