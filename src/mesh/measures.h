#pragma once

#include <array>
#include <cstddef>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Sum of face areas, squared scan units.
double area(const TriangleMesh& mesh);

//! Volume enclosed by a closed mesh, cubic scan units; positive where faces wind outward (divergence
//! theorem).
double enclosed_volume(const TriangleMesh& mesh);

//! The three angles of a triangle, degrees; zero where two corners coincide.
std::array<double, 3> triangle_angles_deg(const Point3& a, const Point3& b, const Point3& c);

//! Angles over a whole mesh, degrees. All zero for a mesh without faces.
struct AngleMeasures
{
    double min_deg = 0.0;      //!< smallest angle of all
    double mean_min_deg = 0.0; //!< mean over the faces of their smallest angle
    double max_deg = 0.0;      //!< largest angle of all
};
AngleMeasures measure_angles(const TriangleMesh& mesh);

//! Number of faces whose smallest angle is below the bound (minus 1e-9 degrees for rounding).
std::size_t count_faces_below_angle(const TriangleMesh& mesh, double bound_deg);

} // namespace voroprobe
