#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Smooths a mesh and keeps its volume nearly: `rounds` times a step towards the middle of the neighbours and
//! a longer one back, which together let the coarse shape pass and damp what is finer than a few edges. The
//! faces stay the same. Vertices on an open border stay where they are. \pre manifold. Cost: linear. Source:
//! Taubin 1995, "A signal processing approach to fair surface design".
TriangleMesh smoothed(const TriangleMesh& mesh, std::size_t rounds);

} // namespace voroprobe
