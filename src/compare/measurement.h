#pragma once

#include <nlohmann/json_fwd.hpp>

#include "certificate/certificate.h"
#include "certificate/mesh_check.h"
#include "compare/reference_surface.h"
#include "compare/shape_measures.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! What is true of one mesh, whoever made it.
struct Measurement
{
    MeshCheck check;
    ShapeMeasures shapes;
    Certificate certificate; //!< pieces are assigned to surfaces by where their vertices lie, for all alike
};

//! Both ways between a mesh and the scan's surface.
struct TwoSidedDistance
{
    double max;              //!< the larger one
    double mean;             //!< of the two means
    double root_mean_square; //!< of both: the root of the mean of their squares
    double percentile_95;    //!< the larger one
};

TwoSidedDistance two_sided(const SurfaceDistance& distance);

//! \pre equal points of the mesh are one vertex. Cost: that of check_mesh() and certify().
Measurement measure(const TriangleMesh& mesh, const ReferenceSurface& reference,
                    const MeasuringOptions& options);

//! The distance alone, for sweeps: samples as in measure().
TwoSidedDistance measure_distance(const TriangleMesh& mesh, const ReferenceSurface& reference,
                                  const MeasuringOptions& options);

//! As report.json has it; lengths in mm, places in the world.
nlohmann::ordered_json to_json(const Measurement& measurement, const ReferenceSurface& reference);

nlohmann::ordered_json to_json(const TwoSidedDistance& distance);

//! [x, y, z]
nlohmann::ordered_json to_json(const Vec3& v);

//! {"min": [x, y, z], "max": [x, y, z]} in the world.
nlohmann::ordered_json box_json(const Box3& box_grid, const AffineTransform& world_from_grid);

} // namespace voroprobe
