#pragma once

#include <array>
#include <cstddef>

#include "compare/histogram.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! How well the triangles of a mesh are shaped. Faces without area, whose ratios are infinite, are counted
//! and left out of the ratios.
struct ShapeMeasures
{
    //! Circumradius to shortest edge: 1 / sqrt 3 for an equilateral triangle, 1 at an angle of 30 degrees,
    //! and 1 / (2 sin a) at a smallest angle a.
    double mean_radius_edge_ratio = 0.0;
    double max_radius_edge_ratio = 0.0;

    //! Longest edge to inradius, 1 for an equilateral triangle (that is, divided by 2 sqrt 3).
    double mean_aspect_ratio = 0.0;
    double max_aspect_ratio = 0.0;

    double mean_edge_length = 0.0; //!< over the sides of the faces, scan units
    std::size_t flat_faces = 0;

    //! Vertices by the number of faces around them; the last: that many or more.
    std::array<std::size_t, 13> vertices_by_valence{};

    Histogram smallest_angles{0.0, 60.0, 60}; //!< of each face, degrees
    Histogram angles{0.0, 180.0, 90};         //!< all, degrees
};

//! \pre faces name existing vertices. Cost: linear.
ShapeMeasures measure_shapes(const TriangleMesh& mesh);

} // namespace voroprobe
