#include "mesher/umbrella.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "support/grouping.h"

namespace voroprobe
{
namespace
{

// From this share of the vertices on, one pass over all facets is quicker than the Delaunay cells around each
// vertex.
constexpr std::size_t kVerticesPerCheckedForOnePass = 64;

// That one thread looks at in a row.
constexpr std::size_t kVerticesAtOnce = 256;

using LinkEdge = std::pair<std::uint32_t, std::uint32_t>;

//! The two vertices of a facet other than `apex`.
LinkEdge link_edge(const RestrictedFacet& facet, std::uint32_t apex)
{
    const auto& [a, b, c] = facet.vertices;
    if (a == apex)
        return {b, c};
    return b == apex ? LinkEdge{a, c} : LinkEdge{a, b};
}

//! The odd facets around chosen vertices, by vertex index; gathered in one pass over all facets.
Grouping<FacetId> odd_facets_of(const RestrictedDelaunay& restricted,
                                const std::vector<VertexHandle>& vertices)
{
    std::vector<std::uint8_t> wanted(restricted.vertex_index_bound(), 0);
    for (const VertexHandle vertex : vertices)
        wanted[vertex->info().index] = 1;
    return {wanted.size(), [&](auto&& visit)
            {
                for (FacetId id = 0; id < restricted.facet_slots(); ++id)
                {
                    if (!restricted.facet(id).odd())
                        continue;
                    for (const std::uint32_t vertex : restricted.facet(id).vertices)
                    {
                        if (wanted[vertex] != 0)
                            visit(vertex, id);
                    }
                }
            }};
}

std::optional<FacetId> largest_above_floor(const RestrictedDelaunay& restricted,
                                           const FacetCriteria& criteria, std::span<const FacetId> facets)
{
    std::optional<FacetId> largest;
    for (const FacetId id : facets)
    {
        const RestrictedFacet& facet = restricted.facet(id);
        if (facet.kept || criteria.at_floor(facet))
            continue;
        if (!largest || facet.squared_radius > restricted.facet(*largest).squared_radius)
            largest = id;
    }
    return largest;
}

//! What a look at one vertex brings to light.
struct Finding
{
    bool is_isolated = false;
    std::optional<FacetId> bad_facet;
};

//! Sets VertexData::pinched.
Finding look_at(VertexHandle vertex, std::span<const FacetId> facets, const RestrictedDelaunay& restricted,
                const FacetCriteria& criteria)
{
    if (facets.empty())
        return {true, std::nullopt};
    vertex->info().pinched = !is_umbrella(restricted, vertex->info().index, facets);
    if (!vertex->info().pinched)
        return {};
    return {false, largest_above_floor(restricted, criteria, facets)};
}

void add(VertexHandle vertex, const Finding& finding, UmbrellaFindings& findings)
{
    if (finding.is_isolated)
        findings.isolated_vertices.push_back(vertex);
    if (finding.bad_facet)
        findings.bad_facets.push_back(*finding.bad_facet);
}

} // namespace

bool is_umbrella(const RestrictedDelaunay& restricted, std::uint32_t vertex, std::span<const FacetId> facets)
{
    if (facets.empty())
        return false;

    // Walk along the link from the first edge; a vertex of the link met by more than two edges shows as a
    // count too high.
    thread_local std::vector<LinkEdge> link;
    link.clear();
    for (const FacetId id : facets)
        link.push_back(link_edge(restricted.facet(id), vertex));

    const std::uint32_t first = link.front().first;
    std::uint32_t end = link.front().second;
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

UmbrellaFindings check_umbrellas(RestrictedDelaunay& restricted, const FacetCriteria& criteria,
                                 const Workers& workers)
{
    UmbrellaFindings findings;
    const std::vector<VertexHandle> vertices = restricted.take_unchecked_vertices();
    if (vertices.size() * kVerticesPerCheckedForOnePass > restricted.vertex_count())
    {
        const Grouping<FacetId> facets = odd_facets_of(restricted, vertices);
        std::vector<Finding> found(vertices.size());
        const auto look = [&](std::size_t v)
        { found[v] = look_at(vertices[v], facets.of(vertices[v]->info().index), restricted, criteria); };
        workers.for_each(vertices.size(), look, kVerticesAtOnce);
        for (std::size_t v = 0; v < vertices.size(); ++v)
            add(vertices[v], found[v], findings);
        return findings;
    }
    std::vector<FacetId> facets;
    for (const VertexHandle vertex : vertices)
    {
        restricted.odd_facets_around(vertex, facets);
        add(vertex, look_at(vertex, facets, restricted, criteria), findings);
    }
    return findings;
}

} // namespace voroprobe
