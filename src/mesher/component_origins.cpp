#include "mesher/component_origins.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/union_find.h"

namespace voroprobe
{
namespace
{

FoundBy found_by(VertexHandle vertex)
{
    if (vertex == VertexHandle())
        return FoundBy::kRefinement;
    if (vertex->info().origin == VertexOrigin::kProbe)
        return FoundBy::kProbe;
    if (vertex->info().origin == VertexOrigin::kCellProbe)
        return FoundBy::kCellProbe;
    if (vertex->info().origin == VertexOrigin::kInventory)
        return FoundBy::kInventory;
    return vertex->info().initializations > 0 ? FoundBy::kIsolatedVertex : FoundBy::kRefinement;
}

} // namespace

std::vector<FoundPiece> find_pieces(const BoundaryComplex& complex,
                                    std::span<const SurfaceId> surface_of_face)
{
    // In a manifold, faces joined at vertices are joined at edges.
    UnionFind joined(complex.mesh.vertices.size());
    for (const auto& face : complex.mesh.faces)
    {
        joined.unite(face[0], face[1]);
        joined.unite(face[0], face[2]);
    }
    std::vector<FoundPiece> piece_of_root(complex.mesh.vertices.size(), {kNoSurface, FoundBy::kRefinement});
    for (std::size_t f = 0; f < complex.mesh.faces.size(); ++f)
        piece_of_root[joined.find(complex.mesh.faces[f][0])].surface = surface_of_face[f];
    std::vector<FoundPiece> pieces;
    for (std::uint32_t vertex = 0; vertex < piece_of_root.size(); ++vertex)
    {
        FoundBy& means = piece_of_root[joined.find(vertex)].found_by;
        means = std::max(means, found_by(complex.vertex_of_copy[vertex]));
    }
    for (std::uint32_t vertex = 0; vertex < piece_of_root.size(); ++vertex)
    {
        if (joined.find(vertex) == vertex)
            pieces.push_back(piece_of_root[vertex]);
    }
    return pieces;
}

std::size_t count_abandoned_vertices(const BoundaryComplex& complex, std::size_t vertices_inserted)
{
    std::vector<bool> used(vertices_inserted, false);
    for (const VertexHandle vertex : complex.vertex_of_copy)
    {
        if (vertex != VertexHandle())
            used[vertex->info().index] = true;
    }
    return static_cast<std::size_t>(std::count(used.begin() + kSentinelCount, used.end(), false));
}

void count_found_pieces(std::span<const FoundPiece> pieces, MeshingStatistics& statistics)
{
    const auto count = [&](FoundBy wanted)
    {
        return static_cast<std::size_t>(std::count_if(pieces.begin(), pieces.end(),
                                                      [wanted](const FoundPiece& piece)
                                                      { return piece.found_by == wanted; }));
    };
    statistics.components_by_initialization = count(FoundBy::kProbe);
    statistics.components_by_probing = count(FoundBy::kCellProbe);
    statistics.components_by_isolated_vertex = count(FoundBy::kIsolatedVertex);
    statistics.components_by_inventory = count(FoundBy::kInventory);
    statistics.components_by_refinement = count(FoundBy::kRefinement);
}

} // namespace voroprobe
