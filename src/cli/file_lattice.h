#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "cli/output_frame.h"

namespace voroprobe
{

//! The lattice of samples as the file describes it: its own axes in its own order, undone from the canonical
//! grid.
struct FileLattice
{
    std::array<std::size_t, 3> size; //!< samples along the axes of the file
    Vec3 spacing;                    //!< mm, along the axes of the file
    Matrix3 direction;               //!< direction cosines by columns, world is LPS
    Point3 origin;                   //!< world position of index (0, 0, 0), mm
};

//! `grid_size`: samples along the axes of the grid frame.
FileLattice file_lattice(const std::array<std::size_t, 3>& grid_size, const GridPlacement& placement);

//! Where the axes of the file run, one letter each (L left, R right, P posterior, A anterior, S superior, I
//! inferior): "LPS" for the identity.
std::string orientation_letters(const Matrix3& direction);

//! Largest angle between an axis of the file and the world axis it runs along, degrees.
double obliqueness_deg(const Matrix3& direction);

} // namespace voroprobe
