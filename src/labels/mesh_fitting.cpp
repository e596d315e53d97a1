#include "labels/mesh_fitting.h"

#include <cmath>
#include <optional>
#include <vector>

namespace voroprobe
{
namespace
{

//! Weighted by area, not normalized.
std::vector<Vec3> vertex_normals(const TriangleMesh& mesh)
{
    std::vector<Vec3> normals(mesh.vertices.size());
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const Point3 a = mesh.corner(face, 0);
        const Vec3 normal = cross(mesh.corner(face, 1) - a, mesh.corner(face, 2) - a);
        for (const std::uint32_t v : face)
            normals[v] += normal;
    }
    return normals;
}

//! The place nearest to the middle of the segment at which it leaves the object. Crossings alternate.
std::optional<Point3> nearest_exit(const SurfaceOracle& oracle, const Segment3& segment,
                                   std::vector<Crossing>& crossings)
{
    oracle.find_crossings(segment, crossings);
    const std::size_t first_exit = is_inside(oracle.region(segment.source)) ? 0 : 1;
    std::optional<Point3> nearest;
    double distance = 1.0;
    for (std::size_t i = first_exit; i < crossings.size(); i += 2)
        if (std::abs(crossings[i].t - 0.5) < distance)
        {
            distance = std::abs(crossings[i].t - 0.5);
            nearest = crossings[i].point;
        }
    return nearest;
}

} // namespace

void move_onto_surface(TriangleMesh& mesh, const SurfaceOracle& oracle, double reach)
{
    const std::vector<Vec3> normals = vertex_normals(mesh);
    std::vector<Crossing> crossings;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    {
        const double length = norm(normals[v]);
        if (!(length > 0.0))
            continue;
        const Vec3 step = (reach / length) * normals[v];
        Point3& p = mesh.vertices[v];
        if (const auto exit = nearest_exit(oracle, {p - step, p + step}, crossings))
            p = *exit;
    }
}

} // namespace voroprobe
