#pragma once

#include <optional>
#include <string>

#include "random_volumes.h"

namespace voroprobe
{

//! Meshes a volume with the defaults of the program and holds the mesh against the inventory: one closed,
//! manifold, oriented piece for every surface, no face crossing another (by a check that shares nothing with
//! the mesher), and still closed and manifold in an STL file. What does not hold, in one line; nullopt where
//! all does.
std::optional<std::string> what_is_wrong_with_the_mesh_of(const RandomVolume& random);

//! The same without the caps: pieces may have a rim, and be several for a surface.
std::optional<std::string> what_is_wrong_with_the_open_mesh_of(const RandomVolume& random);

} // namespace voroprobe
