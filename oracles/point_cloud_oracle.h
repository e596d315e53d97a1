#pragma once

#include <memory>
#include <span>
#include <string>

#include "geometry/oriented_point.h"
#include "mesh/triangle_mesh.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! The zero set of CGAL's Poisson reconstruction of a point cloud with outward normals, exactly as it is: the
//! function is linear on the cells of a Delaunay triangulation of the points and of points added between
//! them, so its zero set is triangles. Closed:
//! where the inside reaches the convex hull of all of these, it ends there.
//!
//! What it is good for: a dense, even sampling of a closed surface, with normals that agree. Its limits: it
//! is a fit, not an interpolation, and lies off the points by a part of their spacing, more where they are
//! noisy; details finer than a few spacings, sharp edges and thin walls are smoothed away; holes are closed
//! by guess; a few normals turned round make bubbles, many make nonsense. Points are weighted alike, so
//! uneven sampling shows. `name` stands for the cloud in messages. Cost: 15 kB and some 50 microseconds a
//! point. Source: Kazhdan, Bolitho & Hoppe, Poisson surface reconstruction, 2006; Alliez et al. in CGAL 5.5.
//! \throw InputError where there are fewer than 10 points, a coordinate is not finite, a normal is zero, the
//! points lie in a plane, the fit does not separate an inside, or the solver fails.
TriangleMesh fit_point_cloud(std::span<const OrientedPoint> points,
                             const std::string& name = "the point cloud");

//! That fit as an oracle. \throw as fit_point_cloud().
std::unique_ptr<SurfaceOracle> make_point_cloud_oracle(std::span<const OrientedPoint> points,
                                                       const std::string& name = "the point cloud");

} // namespace voroprobe
