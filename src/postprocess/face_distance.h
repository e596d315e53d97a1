#pragma once

#include <functional>
#include <memory>

#include "certificate/mesh_distance.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! How far a face, given by its corners, is from the surface it stands for: from its circumcenter, scan
//! units; infinite where there is no surface near, or the face has no area.
using FaceDistance = std::function<double(const Point3&, const Point3&, const Point3&)>;

//! To the nearest point of a mesh.
FaceDistance face_distance_to(std::shared_ptr<const MeshDistance> mesh);

//! To the surface of an oracle, at right angles to the face, at most `reach` (scan units, > 0) away: what
//! refinement bounds. `oracle` must outlive it. Source: Boissonnat & Oudot 2005 (surface Delaunay ball).
FaceDistance face_distance_to(const SurfaceOracle& oracle, double reach);

} // namespace voroprobe
