#pragma once

#include "bench/paper_report.h"

namespace voroprobe::bench
{

//! Figure 1 with numbers: a torus and the implicit surface of Figure 8, sampled on grids and meshed by
//! marching cubes (VTK's FlyingEdges3D), and by Delaunay refinement whose distance criterion is as loose as
//! the same measured distance, both ways between mesh and surface, allows. Compares vertices and angles. The
//! promise is that each of these distances is reached by a closed manifold.
Report compare_with_marching_cubes();

} // namespace voroprobe::bench
