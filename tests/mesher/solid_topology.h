#pragma once

#include <array>
#include <cstddef>

#include "geometry/box3.h"
#include "oracles/surface_oracle.h"
#include "volume/phantoms.h"

namespace voroprobe
{

//! The topology of the surface of a shape, counted without any mesh.
struct SurfaceTopology
{
    std::size_t components = 0;
    long euler_characteristic = 0;

    friend bool operator==(const SurfaceTopology&, const SurfaceTopology&) = default;
};

//! Counts on a lattice of n^3 points of the box, what lies beyond it being outside. Inside points, the
//! lattice's edges, squares and cubes whose corners are all inside form a solid: its boundary has twice its
//! Euler characteristic. Components: inside parts (6 neighbours) and outside parts (26, the other topology)
//! form a tree whose edges are the surfaces. True where the lattice resolves the shape. Cost: O(n^3).
SurfaceTopology count_on_lattice(const LevelFunction& function, const Box3& box, std::size_t n);

} // namespace voroprobe
