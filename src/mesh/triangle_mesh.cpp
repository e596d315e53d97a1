#include "mesh/triangle_mesh.h"

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

void transform(TriangleMesh& mesh, const AffineTransform& to_from_mesh)
{
    for (Point3& p : mesh.vertices)
        p = to_from_mesh * p;

    if (determinant(to_from_mesh.linear) < 0.0)
        for (TriangleMesh::Face& face : mesh.faces)
            std::swap(face[1], face[2]);
}

} // namespace voroprobe
