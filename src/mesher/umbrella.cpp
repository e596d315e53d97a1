#include "mesher/umbrella.h"

#include <array>
#include <utility>
#include <vector>

namespace voroprobe
{
namespace
{

//! The two vertices of a facet other than `apex`.
std::pair<VertexHandle, VertexHandle> link_edge(const RestrictedFacet& facet, VertexHandle apex)
{
    std::array<VertexHandle, 2> ends;
    std::size_t found = 0;
    for (int i = 0; i < 4; ++i)
    {
        const VertexHandle vertex = facet.delaunay_cell->vertex(i);
        if (i != facet.index && vertex != apex && found < 2)
            ends[found++] = vertex;
    }
    return {ends[0], ends[1]};
}

} // namespace

bool is_umbrella(const RestrictedDelaunay& restricted, VertexHandle vertex, std::span<const FacetId> facets)
{
    if (facets.empty())
        return false;

    // Walk along the link from the first edge; a vertex of the link met by more than two edges shows as a
    // count too high.
    thread_local std::vector<std::pair<VertexHandle, VertexHandle>> link;
    link.clear();
    for (const FacetId id : facets)
        link.push_back(link_edge(restricted.facet(id), vertex));

    const VertexHandle first = link.front().first;
    VertexHandle end = link.front().second;
    std::size_t walked = 1;
    while (end != first)
    {
        bool extended = false;
        for (std::size_t i = walked; i < link.size(); ++i)
        {
            if (link[i].first != end && link[i].second != end)
                continue;
            if (extended)
                return false; // a third edge meets here
            extended = true;
            std::swap(link[i], link[walked]);
            if (link[walked].second == end)
                std::swap(link[walked].first, link[walked].second);
        }
        if (!extended)
            return false;
        end = link[walked].second;
        ++walked;
    }
    return walked == link.size();
}

} // namespace voroprobe
