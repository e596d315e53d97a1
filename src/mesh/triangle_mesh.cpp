#include "mesh/triangle_mesh.h"

#include <limits>
#include <utility>

namespace voroprobe
{

Box3 bounding_box(const TriangleMesh& mesh)
{
    Box3 box;
    for (const Point3& p : mesh.vertices)
        box.include(p);
    return box;
}

TriangleMesh with_faces(const TriangleMesh& mesh, const std::vector<bool>& kept)
{
    constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> new_index(mesh.vertices.size(), kUnused);
    TriangleMesh part;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
        if (!kept[f])
            continue;
        TriangleMesh::Face face = mesh.faces[f];
        for (std::uint32_t& corner : face)
        {
            if (new_index[corner] == kUnused)
            {
                new_index[corner] = static_cast<std::uint32_t>(part.vertices.size());
                part.vertices.push_back(mesh.vertices[corner]);
            }
            corner = new_index[corner];
        }
        part.faces.push_back(face);
    }
    return part;
}

void transform(TriangleMesh& mesh, const AffineTransform& to_from_mesh)
{
    for (Point3& p : mesh.vertices)
        p = to_from_mesh * p;

    if (determinant(to_from_mesh.linear) < 0.0)
        for (TriangleMesh::Face& face : mesh.faces)
            std::swap(face[1], face[2]);
}

} // namespace voroprobe
