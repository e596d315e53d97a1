#include "mesh/vertex_normals.h"

#include "mesh/measures.h"

namespace voroprobe
{

std::vector<Vec3> vertex_normals(const TriangleMesh& mesh)
{
    std::vector<Vec3> normals(mesh.vertices.size());
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const Point3 a = mesh.corner(face, 0);
        const Point3 b = mesh.corner(face, 1);
        const Point3 c = mesh.corner(face, 2);
        const Vec3 out = normalized(cross(b - a, c - a));
        const std::array<double, 3> angles = triangle_angles_deg(a, b, c);
        for (std::size_t i = 0; i < 3; ++i)
            normals[face[i]] += angles[i] * out;
    }
    for (Vec3& normal : normals)
        normal = normalized(normal);
    return normals;
}

} // namespace voroprobe
