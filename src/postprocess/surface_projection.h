#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "certificate/mesh_distance.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! The point of a surface next to a point beside it, and the way out there; nullopt where there is none near.
using SurfaceProjection = std::function<std::optional<NearestPoint>(const Point3&)>;

//! Onto a mesh.
SurfaceProjection projection_onto(std::shared_ptr<const MeshDistance> mesh);

//! Onto the surface of an oracle: from the nearest point of a mesh of it, along the mesh's normal, at most
//! `reach` (scan units, > 0) away. The normal is the mesh's. `oracle` must outlive the projection.
SurfaceProjection projection_onto(const SurfaceOracle& oracle, std::shared_ptr<const MeshDistance> mesh,
                                  double reach);

} // namespace voroprobe
