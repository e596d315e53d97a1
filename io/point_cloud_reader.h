#pragma once

#include <filesystem>
#include <vector>

#include "geometry/oriented_point.h"

namespace voroprobe
{

//! Reads a text file of points with normals, one a line: x y z nx ny nz, separated by blanks; what follows on
//! the line is passed over, as are empty lines and those that begin with #. \throw InputError with the path,
//! the line and the reason.
std::vector<OrientedPoint> read_point_cloud(const std::filesystem::path& path);

} // namespace voroprobe
