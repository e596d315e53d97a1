#include "mesher/component_origins.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/union_find.h"

namespace voroprobe
{
namespace
{

//! Means by which a piece was found; where several apply the later one counts.
enum class FoundBy : std::uint8_t
{
    kRefinement,
    kIsolatedVertex,
    kInventory,
    kCellProbe,
    kProbe
};

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

void count_component_origins(const BoundaryComplex& complex, std::size_t vertices_inserted,
                             MeshingStatistics& statistics)
{
    UnionFind pieces(
        complex.mesh.vertices.size()); // in a manifold, faces joined at vertices are joined at edges
    for (const auto& face : complex.mesh.faces)
    {
        pieces.unite(face[0], face[1]);
        pieces.unite(face[0], face[2]);
    }
    std::vector<FoundBy> means(complex.mesh.vertices.size(), FoundBy::kRefinement);
    for (std::uint32_t vertex = 0; vertex < means.size(); ++vertex)
    {
        const std::uint32_t piece = pieces.find(vertex);
        means[piece] = std::max(means[piece], found_by(complex.vertex_of_copy[vertex]));
    }
    std::vector<bool> used(vertices_inserted, false);
    for (const VertexHandle vertex : complex.vertex_of_copy)
    {
        if (vertex != VertexHandle())
            used[vertex->info().index] = true;
    }
    statistics.isolated_vertices_abandoned =
        static_cast<std::size_t>(std::count(used.begin() + kSentinelCount, used.end(), false));

    const auto count = [&](FoundBy wanted)
    {
        std::size_t found = 0;
        for (std::uint32_t vertex = 0; vertex < means.size(); ++vertex)
            found += pieces.find(vertex) == vertex && means[vertex] == wanted ? 1 : 0;
        return found;
    };
    statistics.components_by_initialization = count(FoundBy::kProbe);
    statistics.components_by_probing = count(FoundBy::kCellProbe);
    statistics.components_by_isolated_vertex = count(FoundBy::kIsolatedVertex);
    statistics.components_by_inventory = count(FoundBy::kInventory);
    statistics.components_by_refinement = count(FoundBy::kRefinement);
}

} // namespace voroprobe
