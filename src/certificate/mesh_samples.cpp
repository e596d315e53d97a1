#include "certificate/mesh_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesh/measures.h"

namespace voroprobe
{

namespace
{

using Face = TriangleMesh::Face;

//! Three corners, three middles of sides, the centroid.
constexpr std::size_t kLandmarksOfFace = 7;

Vec3 face_normal(const TriangleMesh& mesh, const Face& face)
{
    const Point3 a = mesh.corner(face, 0);
    return normalized(cross(mesh.corner(face, 1) - a, mesh.corner(face, 2) - a));
}

Point3 landmark(const TriangleMesh& mesh, const Face& face, std::size_t which)
{
    if (which < 3)
        return mesh.corner(face, which);
    if (which < 6)
        return 0.5 * (mesh.corner(face, which - 3) + mesh.corner(face, (which - 2) % 3));
    return (mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3.0;
}

double face_area(const TriangleMesh& mesh, const Face& face)
{
    const Point3 a = mesh.corner(face, 0);
    return 0.5 * norm(cross(mesh.corner(face, 1) - a, mesh.corner(face, 2) - a));
}

//! Uniform over the face. Source: Turk, Generating random points in triangles, Graphics Gems, 1990.
Point3 random_point(const TriangleMesh& mesh, const Face& face, Random& random)
{
    const double root = std::sqrt(random.uniform());
    const double share = random.uniform();
    return (1.0 - root) * mesh.corner(face, 0) + root * (1.0 - share) * mesh.corner(face, 1) +
           root * share * mesh.corner(face, 2);
}

} // namespace

std::vector<MeshSample> mesh_landmarks(const TriangleMesh& mesh, std::size_t most)
{
    const std::size_t all = kLandmarksOfFace * mesh.faces.size();
    const std::size_t count = std::min(most, all);
    std::vector<MeshSample> samples;
    samples.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
    {
        const auto chosen = static_cast<std::size_t>((static_cast<double>(i) + 0.5) *
                                                     static_cast<double>(all) / static_cast<double>(count));
        const Face& face = mesh.faces[std::min(chosen, all - 1) / kLandmarksOfFace];
        samples.push_back({landmark(mesh, face, chosen % kLandmarksOfFace), face_normal(mesh, face)});
    }
    return samples;
}

std::vector<MeshSample> area_samples(const TriangleMesh& mesh, std::size_t count, Random& random)
{
    return area_samples(mesh, area(mesh), count, random);
}

std::vector<MeshSample> area_samples(const TriangleMesh& mesh, double total_area, std::size_t count,
                                     Random& random)
{
    std::vector<MeshSample> samples;
    if (!(total_area > 0.0))
        return samples;
    samples.reserve(count);
    const double part = total_area / static_cast<double>(count);
    double area_so_far = 0.0;
    double next = part * random.uniform();
    for (const Face& face : mesh.faces)
    {
        area_so_far += face_area(mesh, face);
        while (next < area_so_far && samples.size() < count)
        {
            samples.push_back({random_point(mesh, face, random), face_normal(mesh, face)});
            next = part * (static_cast<double>(samples.size()) + random.uniform());
        }
    }
    return samples;
}

double typical_edge_length(const TriangleMesh& mesh)
{
    return typical_edge_length(mesh, area(mesh));
}

double typical_edge_length(const TriangleMesh& mesh, double total_area)
{
    const double mean_area = total_area / std::max<double>(1.0, static_cast<double>(mesh.faces.size()));
    return std::sqrt(4.0 * mean_area / std::numbers::sqrt3);
}

} // namespace voroprobe
