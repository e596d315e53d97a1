#include "compare/decimation.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <meshoptimizer.h>

namespace voroprobe
{

namespace
{

//! The number of faces ends the work, not the error: any deformation is allowed.
constexpr float kAnyError = std::numeric_limits<float>::max();
constexpr unsigned kNoOptions = 0;

using FloatPoint = std::array<float, 3>;

//! From the middle of the mesh: far from the origin floats are coarse.
std::vector<FloatPoint> float_points(const TriangleMesh& mesh)
{
    const Point3 center = bounding_box(mesh).center();
    std::vector<FloatPoint> points;
    points.reserve(mesh.vertices.size());
    for (const Point3& p : mesh.vertices)
        points.push_back({static_cast<float>(p.x - center.x), static_cast<float>(p.y - center.y),
                          static_cast<float>(p.z - center.z)});
    return points;
}

std::vector<unsigned> corners_of(const TriangleMesh& mesh)
{
    std::vector<unsigned> corners;
    corners.reserve(3 * mesh.faces.size());
    for (const TriangleMesh::Face& face : mesh.faces)
        corners.insert(corners.end(), face.begin(), face.end());
    return corners;
}

} // namespace

std::vector<TriangleMesh::Face> decimated_faces(const TriangleMesh& mesh, std::size_t most)
{
    if (most >= mesh.faces.size())
        return mesh.faces;
    const std::vector<FloatPoint> points = float_points(mesh);
    const std::vector<unsigned> corners = corners_of(mesh);
    std::vector<unsigned> kept(corners.size());
    kept.resize(meshopt_simplify(kept.data(), corners.data(), corners.size(), points.front().data(),
                                 points.size(), sizeof(FloatPoint), 3 * most, kAnyError, kNoOptions,
                                 nullptr));
    std::vector<TriangleMesh::Face> faces;
    faces.reserve(kept.size() / 3);
    for (std::size_t i = 0; i < kept.size(); i += 3)
        faces.push_back({kept[i], kept[i + 1], kept[i + 2]});
    return faces;
}

} // namespace voroprobe
