#include "postprocess/smoothing.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "certificate/self_intersections.h"

namespace voroprobe
{

namespace
{

//! Shares of the way to the middle of the neighbours, forth and back: signals pass up to a frequency of
//! 1 / kForth + 1 / kBack = 0.1, of 2. Taubin's own choice.
constexpr double kForth = 0.6307;
constexpr double kBack = -0.6732;

//! Vertices that may go less than this share of their way stay.
constexpr double kLeastShare = 0.25;

//! The middle of the neighbours of every vertex. On a closed mesh every neighbour is met twice.
class Neighbourhood
{
public:
    explicit Neighbourhood(const TriangleMesh& mesh)
        : mesh_(mesh), balance_(mesh.vertices.size()), faces_(balance_)
    {
        for (const TriangleMesh::Face& face : mesh.faces)
            for (std::size_t i = 0; i < 3; ++i)
            {
                ++faces_[face[i]];
                balance_[face[i]] +=
                    static_cast<long>(face[(i + 1) % 3]) - static_cast<long>(face[(i + 2) % 3]);
            }
    }

    //! Around an inner vertex every neighbour follows in one face and precedes in another.
    [[nodiscard]] bool is_inner(std::size_t v) const { return faces_[v] > 0 && balance_[v] == 0; }

    [[nodiscard]] std::vector<Vec3> ways_to_middle(const std::vector<Point3>& points) const
    {
        std::vector<Vec3> ways(points.size());
        for (const TriangleMesh::Face& face : mesh_.faces)
            for (std::size_t i = 0; i < 3; ++i)
                ways[face[i]] +=
                    (points[face[(i + 1) % 3]] - points[face[i]]) / static_cast<double>(faces_[face[i]]);
        return ways;
    }

private:
    const TriangleMesh& mesh_;
    std::vector<long> balance_;
    std::vector<long> faces_;
};

TriangleMesh smoothed(const TriangleMesh& mesh, std::size_t rounds)
{
    const Neighbourhood neighbourhood(mesh);
    TriangleMesh result = mesh;
    for (std::size_t step = 0; step < 2 * rounds; ++step)
    {
        const std::vector<Vec3> ways = neighbourhood.ways_to_middle(result.vertices);
        for (std::size_t v = 0; v < ways.size(); ++v)
            if (neighbourhood.is_inner(v))
                result.vertices[v] += (step % 2 == 0 ? kForth : kBack) * ways[v];
    }
    return result;
}

//! Vertices of the pairs of faces that cross in one mesh and not in the other; ascending.
std::set<std::uint32_t> vertices_that_cross(const TriangleMesh& mesh, const std::vector<FacePair>& before)
{
    std::set<std::uint32_t> vertices;
    for (const FacePair& pair : self_intersections(mesh))
        if (!std::binary_search(before.begin(), before.end(), pair))
            for (const std::uint32_t f : {pair.first, pair.second})
                vertices.insert(mesh.faces[f].begin(), mesh.faces[f].end());
    return vertices;
}

} // namespace

SmoothingResult smooth(const TriangleMesh& mesh, std::size_t rounds)
{
    const TriangleMesh goal = smoothed(mesh, rounds);
    const std::vector<FacePair> crossings_before = self_intersections(mesh);
    SmoothingResult result{.mesh = goal};
    std::vector<double> share(mesh.vertices.size(), 1.0); // of its way that each vertex goes
    for (std::set<std::uint32_t> crossing;
         !(crossing = vertices_that_cross(result.mesh, crossings_before)).empty();)
        for (const std::uint32_t v : crossing)
        {
            share[v] = share[v] > kLeastShare ? 0.5 * share[v] : 0.0;
            const Point3& from = mesh.vertices[v];
            result.mesh.vertices[v] = share[v] > 0.0 ? from + share[v] * (goal.vertices[v] - from) : from;
        }
    result.vertices_held = static_cast<std::size_t>(
        std::count_if(share.begin(), share.end(), [](double went) { return went < 1.0; }));
    return result;
}

} // namespace voroprobe
