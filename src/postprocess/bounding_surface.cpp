#include "postprocess/bounding_surface.h"

#include <algorithm>

namespace voroprobe
{

std::size_t count_beyond(const TriangleMesh& mesh, const BoundingSurface& surface)
{
    const auto is_beyond = [&](const TriangleMesh::Face& face)
    {
        return surface.distance(mesh.corner(face, 0), mesh.corner(face, 1), mesh.corner(face, 2)) >
               surface.max_distance;
    };
    return static_cast<std::size_t>(std::count_if(mesh.faces.begin(), mesh.faces.end(), is_beyond));
}

} // namespace voroprobe
