#pragma once

#include "mesher/cap_finder.h"
#include "mesher/capped_mesh.h"

namespace voroprobe
{

//! Cuts the caps off along the rim, where the surface meets the border of the domain. The edges that lead
//! from a cap to the surface tell where it runs: the cap's last point across each is the rim's, found by
//! bisection. An end near to it moves there, other edges are divided. Faces without a part of the surface go.
//! Cost: some twenty queries for each of these edges.
void cut_along_rim(CapFinder& caps, CappedMesh& capped);

} // namespace voroprobe
