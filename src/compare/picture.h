#pragma once

#include <string>

#include "geometry/box3.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! A PNG of a mesh for papers: the whole on the left, its triangles in a fifth of the box on the right, seen
//! from the front, to one side and a little above; the same camera for all meshes of one box. World, mm.
//! Drawn by VTK, which ends the process where there is no X display: to be called in a child process, see
//! VirtualDisplay.
std::string draw_picture(const TriangleMesh& mesh, const Box3& box);

} // namespace voroprobe
