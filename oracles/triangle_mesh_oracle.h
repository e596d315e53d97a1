#pragma once

#include <memory>
#include <string>

#include "mesh/triangle_mesh.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! What is asked of a mesh before it bounds an object.
enum class MeshChecks
{
    kClosedAndFreeOfCrossings, //!< and its faces meet at shared corners and edges only
    kClosed                    //!< for meshes that are known not to cross themselves, but for rounding
};

//! The surface of a closed triangle mesh, for remeshing. Inside: what lies behind an odd number of faces, so
//! the windings of the faces do not matter, and a closed piece within another is a cavity.
//!
//! Exact: which faces a segment crosses is decided by predicates without rounding, as if all query points
//! were moved by one and the same infinitesimal vector (h, h^2, h^3). No segment then meets an edge or a
//! corner, and none lies in a face; sides and crossings of any two points agree. Only the place of a crossing
//! is rounded. Faces without area are never crossed. Queries go through CGAL's AABB tree: O(log n) for short
//! segments, plus the faces met; region() follows the shortest axis-parallel way out. Source: Edelsbrunner &
//! Muecke, Simulation of simplicity, 1990.
//!
//! `name` stands for the mesh in messages. \throw InputError where the mesh has no face, a coordinate is not
//! finite, an edge is on an odd number of faces, or faces cross. Cost: O(n log n), some 400 bytes a face.
std::unique_ptr<SurfaceOracle>
make_triangle_mesh_oracle(const TriangleMesh& mesh, const std::string& name = "the mesh",
                          MeshChecks checks = MeshChecks::kClosedAndFreeOfCrossings);

} // namespace voroprobe
