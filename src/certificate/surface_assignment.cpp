#include "certificate/surface_assignment.h"

#include <algorithm>
#include <tuple>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "certificate/mesh_samples.h"

namespace voroprobe
{

namespace
{

//! The first search around a vertex goes that far, as a share of the typical edge.
constexpr double kFirstReach = 0.1;

//! Where the oracle cannot name the surface at a crossing, the regions that far to both sides do, as a share
//! of the typical edge.
constexpr double kBeside = 1e-4;

//! Sums of the normals of the faces around each vertex, weighted by their area; faces without area add none.
std::vector<Vec3> vertex_normals(const TriangleMesh& mesh)
{
    std::vector<Vec3> normals(mesh.vertices.size());
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const Point3 a = mesh.corner(face, 0);
        const Vec3 twice_area = cross(mesh.corner(face, 1) - a, mesh.corner(face, 2) - a);
        for (const std::uint32_t v : face)
            normals[v] += twice_area;
    }
    for (Vec3& normal : normals)
        normal = normalized(normal);
    return normals;
}

SurfaceId surface_through(const SurfaceOracle& oracle, const NearestCrossing::Found& found, double beside)
{
    const SurfaceId surface = oracle.surface_at(found.crossing.point);
    if (surface != kNoSurface)
        return surface;
    return oracle.surface_between(oracle.region(found.crossing.point - beside * found.direction),
                                  oracle.region(found.crossing.point + beside * found.direction));
}

double face_area(const TriangleMesh& mesh, const TriangleMesh::Face& face)
{
    const Point3 a = mesh.corner(face, 0);
    return 0.5 * norm(cross(mesh.corner(face, 1) - a, mesh.corner(face, 2) - a));
}

//! Equal pairs of piece and surface added up, the largest of each piece first.
std::vector<Share> merged(std::vector<Share> shares)
{
    std::stable_sort(shares.begin(), shares.end(),
                     [](const Share& a, const Share& b)
                     { return std::tie(a.piece, a.surface) < std::tie(b.piece, b.surface); });
    std::vector<Share> sums;
    for (const Share& share : shares)
    {
        if (!sums.empty() && sums.back().piece == share.piece && sums.back().surface == share.surface)
            sums.back().area += share.area;
        else
            sums.push_back(share);
    }
    std::stable_sort(sums.begin(), sums.end(),
                     [](const Share& a, const Share& b)
                     { return a.piece != b.piece ? a.piece < b.piece : a.area > b.area; });
    return sums;
}

//! Adds to the last share where it is of the same piece and surface: neighbours in the list usually are.
void add(std::vector<Share>& shares, const Share& share)
{
    if (!shares.empty() && shares.back().piece == share.piece && shares.back().surface == share.surface)
        shares.back().area += share.area;
    else
        shares.push_back(share);
}

} // namespace

std::vector<SurfaceId> surface_of_vertices(const TriangleMesh& mesh, const SurfaceOracle& oracle,
                                           double reach, BorderCaps caps)
{
    const std::vector<Vec3> normals = vertex_normals(mesh);
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const TriangleMesh::Face& face : mesh.faces)
        for (const std::uint32_t v : face)
            used[v] = true;
    const double edge = typical_edge_length(mesh);
    const double first_reach = std::min(reach, edge > 0.0 ? kFirstReach * edge : reach);
    std::vector<SurfaceId> surfaces(mesh.vertices.size(), kNoSurface);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.vertices.size()),
                      [&](const tbb::blocked_range<std::size_t>& range)
                      {
                          NearestCrossing search(oracle, caps);
                          for (std::size_t v = range.begin(); v < range.end(); ++v)
                          {
                              const auto found =
                                  used[v] ? search.near(mesh.vertices[v], normals[v], first_reach, reach)
                                          : std::nullopt;
                              if (found)
                                  surfaces[v] = surface_through(oracle, *found, kBeside * edge);
                          }
                      });
    return surfaces;
}

std::vector<Share> shares_of_vertices(const TriangleMesh& mesh,
                                      const std::vector<std::uint32_t>& piece_of_face,
                                      const std::vector<SurfaceId>& surface_of_vertex)
{
    std::vector<Share> shares;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (const std::uint32_t v : mesh.faces[f])
            add(shares, {piece_of_face[f], surface_of_vertex[v], face_area(mesh, mesh.faces[f]) / 3.0});
    return merged(std::move(shares));
}

std::vector<Share> shares_of_faces(const TriangleMesh& mesh, const std::vector<std::uint32_t>& piece_of_face,
                                   const std::vector<SurfaceId>& surface_of_face)
{
    std::vector<Share> shares;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        add(shares, {piece_of_face[f], surface_of_face[f], face_area(mesh, mesh.faces[f])});
    return merged(std::move(shares));
}

} // namespace voroprobe
