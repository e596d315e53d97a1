#include "certificate/lost_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "oracles/coverage.h"

namespace voroprobe
{
namespace
{

double longest_side(const TriangleMesh& mesh)
{
    double squared = 0.0;
    for (const TriangleMesh::Face& face : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i)
            squared =
                std::max(squared, squared_distance(mesh.corner(face, i), mesh.corner(face, (i + 1) % 3)));
    return std::sqrt(squared);
}

std::vector<SurfacePoint> vertices_on_surfaces(const TriangleMesh& mesh,
                                               std::span<const SurfaceId> surface_of_face)
{
    std::vector<SurfacePoint> vertices;
    std::vector<SurfaceId> noted(mesh.vertices.size(), kNoSurface);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
        const SurfaceId surface = surface_of_face[f];
        for (std::size_t i = 0; surface != kNoSurface && i < 3; ++i)
        {
            if (std::exchange(noted[mesh.faces[f][i]], surface) != surface)
                vertices.push_back({surface, mesh.corner(mesh.faces[f], i)});
        }
    }
    return vertices;
}

bool is_on_border(const Point3& p, const Box3& domain)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (p[axis] <= domain.min[axis] || p[axis] >= domain.max[axis])
            return true;
    return false;
}

//! Whether another crossing is within the diameter of a ball of the floor's radius, from p along one of the
//! axes.
bool is_thin_at(const Point3& p, const SurfaceOracle& oracle, double floor_radius)
{
    const double reach = 2.0 * floor_radius;
    std::vector<Crossing> crossings;
    for (const Vec3& axis : {Vec3{reach, 0, 0}, Vec3{0, reach, 0}, Vec3{0, 0, reach}})
    {
        oracle.find_crossings({p - axis, p + axis}, crossings);
        if (crossings.size() >= 2)
            return true;
    }
    return false;
}

} // namespace

std::vector<LostPart> find_lost_parts(const TriangleMesh& mesh, std::span<const SurfaceId> surface_of_face,
                                      const SurfaceOracle& oracle, double reach, double floor_radius)
{
    if (oracle.surface_count() == 0)
        return {};
    const double radius = longest_side(mesh) + reach;
    const std::vector<SurfacePoint> vertices = vertices_on_surfaces(mesh, surface_of_face);
    std::vector<bool> has_faces(oracle.surface_count(), false);
    for (const SurfacePoint& at : vertices)
        has_faces[static_cast<std::size_t>(at.surface)] = true;

    std::map<SurfaceId, LostPart> lost;
    for (const SurfacePoint& at :
         find_uncovered_points(oracle, vertices, radius, radius * std::numbers::inv_sqrt3, 0))
    {
        if (!has_faces[static_cast<std::size_t>(at.surface)] || is_on_border(at.point, oracle.domain()))
            continue;
        LostPart& part = lost.try_emplace(at.surface, LostPart{at.surface, 0, 0, at.point}).first->second;
        ++part.points;
        if (is_thin_at(at.point, oracle, floor_radius))
            ++part.points_of_hairs;
        else
            part.place = at.point;
    }
    std::vector<LostPart> parts;
    for (const auto& [surface, part] : lost)
        parts.push_back(part);
    return parts;
}

} // namespace voroprobe
