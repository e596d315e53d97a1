#pragma once

#include "geometry/box3.h"
#include "mesher/surface_extraction.h"

namespace voroprobe
{

//! Drops the faces that lie on a side of the box, to within `tolerance`, and the vertices on no face any
//! more. Vertices whose faces are then several fans get a copy for each, moved by a hair into its fan: the
//! mesh is a manifold with a rim.
void open_border(const Box3& box, double tolerance, ExtractedSurface& surface);

} // namespace voroprobe
