#include "mesh/edge_table.h"

#include <algorithm>
#include <limits>

#include "support/check.h"

namespace voroprobe
{
namespace
{

template <typename Visitor>
void for_each_side(const TriangleMesh& mesh, Visitor visit)
{
    std::uint32_t corner = 0;
    for (const TriangleMesh::Face& face : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i, ++corner)
        {
            const auto [low, high] = std::minmax(face[i], face[(i + 1) % 3]);
            CHECK_LT(high, mesh.vertices.size());
            if (low != high)
                visit(low, EdgeTable::Side{high, corner});
        }
}

} // namespace

EdgeTable::EdgeTable(const TriangleMesh& mesh)
    : sides_(mesh.vertices.size(), [&](auto&& visit) { for_each_side(mesh, visit); }),
      vertex_count_(mesh.vertices.size())
{
    CHECK_LE(mesh.faces.size(), std::numeric_limits<std::uint32_t>::max() / 3);
    for (std::size_t v = 0; v < vertex_count_; ++v)
        std::sort(sides_.of(v).begin(), sides_.of(v).end());
}

} // namespace voroprobe
