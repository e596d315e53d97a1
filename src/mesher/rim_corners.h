#pragma once

#include "geometry/box3.h"
#include "mesher/cap_finder.h"
#include "mesher/capped_mesh.h"

namespace voroprobe
{

//! Gives the rim of a mesh without caps its corners, where the surface passes an edge of the box: the rim's
//! edges from one side of the box to the next would cut them off. Cost: a query for each corner.
void add_rim_corners(const Box3& domain, CapFinder& caps, CappedMesh& capped);

} // namespace voroprobe
