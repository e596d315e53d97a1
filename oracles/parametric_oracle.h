#pragma once

#include <functional>
#include <memory>

#include "mesh/triangle_mesh.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! A surface as the image of the unit square. It is closed where each side of the square is either joined to
//! the opposite side or shrinks to one point: a torus joins both pairs, a sphere in longitude u and latitude
//! v joins the ends of u and has its poles at the ends of v.
struct ParametricSurface
{
    std::function<Point3(double u, double v)> point; //!< scan units; continuous on [0, 1]^2, pure
    bool joined_in_u = false; //!< point(0, v) is point(1, v): only the first is asked for
    bool joined_in_v = false;
};

//! Triangles between the points of a lattice over the square, fine enough in each direction that the middles
//! of their edges are within `tolerance` > 0, scan units, of the surface's point there. That is sampled, not
//! proved: details between the points of a lattice of 16 x 16 may be passed over. Sides that shrink to a
//! point (to a billionth of the surface's diagonal) become one vertex. Cost: some 5 calls per lattice point.
//! \throw UsageError where the tolerance is not above 0, a point is not finite, or more than 2^22 lattice
//! points would be needed.
TriangleMesh tessellate(const ParametricSurface& surface, double tolerance);

//! The tessellated surface as an oracle; inside is what it encloses, whichever way it is parametrized. \throw
//! as tessellate() and make_triangle_mesh_oracle(): InputError where it is not closed or crosses itself.
std::unique_ptr<SurfaceOracle> make_parametric_oracle(const ParametricSurface& surface, double tolerance);

} // namespace voroprobe
