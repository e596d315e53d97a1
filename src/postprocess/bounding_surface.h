#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.h"
#include "postprocess/face_distance.h"
#include "postprocess/surface_projection.h"

namespace voroprobe
{

//! The surface that a mesh is to keep to, and how nearly.
struct BoundingSurface
{
    SurfaceProjection projection;
    FaceDistance distance;

    //! Of the faces, scan units, > 0.
    double max_distance;
};

//! Faces farther from the surface than that.
std::size_t count_beyond(const TriangleMesh& mesh, const BoundingSurface& surface);

} // namespace voroprobe
