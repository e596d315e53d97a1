#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

struct SmoothingResult
{
    TriangleMesh mesh; //!< faces as before
    std::size_t vertices_held = 0;
};

//! Smooths a mesh and keeps its volume nearly: `rounds` times a step towards the middle of the neighbours and
//! a longer one back, which together let the coarse shape pass and damp what is finer than a few edges. The
//! faces stay the same. Vertices on an open border stay where they are, and those whose faces would come to
//! cross others go half of the way, a quarter, or stay. \pre manifold. Cost: linear, and some tests of
//! crossing. Source: Taubin 1995, "A signal processing approach to fair surface design".
SmoothingResult smooth(const TriangleMesh& mesh, std::size_t rounds);

} // namespace voroprobe
