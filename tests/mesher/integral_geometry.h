#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! Area and volume of what a surface bounds.
struct SurfaceMeasures
{
    double area = 0.0;
    double volume = 0.0;
};

//! Measures a surface with straight lines and without any mesh: in each of `directions` directions, spread
//! evenly, a square lattice of lines^2 parallel lines, shifted at random, covers the domain. The area is
//! twice the mean number of crossings per unit of area of the lattice (Cauchy & Crofton), the volume the mean
//! length inside. Error for smooth surfaces a few tenths of a percent where the lattice is half as fine as
//! the shape. Cost: directions * lines^2 queries.
SurfaceMeasures measure_with_lines(const SurfaceOracle& oracle, std::size_t directions, std::size_t lines);

//! The largest curvature of the zero set of a smooth function at the given points of it, by central
//! differences over `step`: the root of the sum of the two principal curvatures squared, an upper bound.
double largest_curvature(const std::function<double(const Point3&)>& function,
                         const std::vector<Point3>& points, double step);

} // namespace voroprobe
