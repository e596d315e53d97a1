#include "mesher/component_origins.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "mesh/topology.h"

namespace voroprobe
{
namespace
{

//! Means by which a piece was found; where several apply the later one counts.
enum class FoundBy : std::uint8_t
{
    kRefinement,
    kIsolatedVertex,
    kProbe
};

FoundBy found_by(VertexHandle vertex)
{
    if (vertex == VertexHandle())
        return FoundBy::kRefinement;
    if (vertex->info().origin == VertexOrigin::kProbe)
        return FoundBy::kProbe;
    return vertex->info().initializations > 0 ? FoundBy::kIsolatedVertex : FoundBy::kRefinement;
}

} // namespace

void count_component_origins(const BoundaryComplex& complex, MeshingStatistics& statistics)
{
    const auto component_of_face = component_of_faces(complex.mesh);
    std::vector<FoundBy> means;
    for (std::size_t f = 0; f < complex.mesh.faces.size(); ++f)
    {
        const std::uint32_t component = component_of_face[f];
        means.resize(std::max<std::size_t>(means.size(), component + 1), FoundBy::kRefinement);
        for (const std::uint32_t vertex : complex.mesh.faces[f])
            means[component] = std::max(means[component], found_by(complex.vertex_of_copy[vertex]));
    }
    const auto count = [&](FoundBy wanted)
    { return static_cast<std::size_t>(std::count(means.begin(), means.end(), wanted)); };
    statistics.components_by_initialization = count(FoundBy::kProbe);
    statistics.components_by_isolated_vertex = count(FoundBy::kIsolatedVertex);
    statistics.components_by_refinement = count(FoundBy::kRefinement);
}

} // namespace voroprobe
