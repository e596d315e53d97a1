#include "mesh/mesh_part.h"

namespace voroprobe
{

TriangleMesh merged(std::span<const MeshPart> parts)
{
    TriangleMesh whole;
    for (const MeshPart& part : parts)
    {
        const auto first = static_cast<std::uint32_t>(whole.vertices.size());
        whole.vertices.insert(whole.vertices.end(), part.mesh.vertices.begin(), part.mesh.vertices.end());
        whole.faces.reserve(whole.faces.size() + part.mesh.faces.size());
        for (const TriangleMesh::Face& face : part.mesh.faces)
            whole.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
    }
    return whole;
}

} // namespace voroprobe
