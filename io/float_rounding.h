#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Which numbers a format keeps apart: floats of so many binary digits that are multiples of a step.
struct StoredNumbers
{
    int binary_digits = 24; //!< at most those of a float
    double step = 0.0;      //!< a power of two; 0: none
};

//! A mesh whose coordinates are 32-bit floats, and what that took.
struct FloatRounding
{
    TriangleMesh mesh;               //!< the same faces; every coordinate is exactly a float
    std::size_t vertices_nudged = 0; //!< not at the float nearest to them
};

//! Rounds every coordinate to the nearest float, except where that would undo what the mesh promises: no two
//! vertices may fall together, and no face may lose its area or turn its normal by 90 degrees or more against
//! the unrounded one. There, the fewest vertices are moved to a float point nearby, preferably towards their
//! own neighbours: two sheets that nearly touch part rather than cross. Faces that have no area before
//! rounding are not judged. Deterministic. Cost: O(n log n), and O(conflicts) beyond. \throw OutputError when
//! a coordinate exceeds the range of floats, or when the mesh is too fine for them so far from the origin.
//! `numbers`: of a format that keeps fewer apart than floats are, "nearest float" means the nearest of those.
FloatRounding round_to_float(const TriangleMesh& mesh, const StoredNumbers& numbers = {});

} // namespace voroprobe
