#pragma once

#include <optional>

#include "geometry/box3.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! What is measured on the finished mesh, in the grid frame: mm whatever coordinates are written.
struct MeshFacts
{
    std::size_t vertices = 0;
    std::size_t faces = 0;
    MeshTopology topology;
    std::size_t coincident_vertices = 0; //!< at the place of another: a reader that welds would make them one
    double area_mm2 = 0.0;
    double volume_mm3 = 0.0; //!< enclosed; of no meaning where the mesh is not closed
    AngleMeasures angles;
    std::size_t faces_below_angle_bound = 0;
};

//! `topology`: that of the mesh, where it is known.
MeshFacts measure_mesh(const TriangleMesh& mesh, double angle_bound_deg,
                       const std::optional<MeshTopology>& topology = std::nullopt);

} // namespace voroprobe
