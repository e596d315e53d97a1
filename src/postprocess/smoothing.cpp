#include "postprocess/smoothing.h"

#include <cstdint>
#include <vector>

namespace voroprobe
{

namespace
{

//! Shares of the way to the middle of the neighbours, forth and back: signals pass up to a frequency of
//! 1 / kForth + 1 / kBack = 0.1, of 2. Taubin's own choice.
constexpr double kForth = 0.6307;
constexpr double kBack = -0.6732;

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

} // namespace

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

} // namespace voroprobe
