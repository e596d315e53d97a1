#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesher/criteria.h"
#include "mesher/restricted_delaunay.h"
#include "support/workers.h"

namespace voroprobe
{

//! Whether the given odd facets, all those around the vertex with index `vertex`, form one closed umbrella:
//! their edges opposite the vertex are one cycle. False for an empty set.
bool is_umbrella(const RestrictedDelaunay& restricted, std::uint32_t vertex, std::span<const FacetId> facets);

//! What a look at all vertices whose odd facets have changed brings to light.
struct UmbrellaFindings
{
    std::vector<FacetId> bad_facets; //!< the largest facet above the floor around each pinched vertex
    std::vector<VertexHandle> isolated_vertices; //!< vertices on no odd facet
};

//! The manifold criterion: looks at all vertices whose odd facets changed since they were last looked at, and
//! sets VertexData::pinched. Cost: O(facets) for many vertices, O(their Delaunay cells) for few.
UmbrellaFindings check_umbrellas(RestrictedDelaunay& restricted, const FacetCriteria& criteria,
                                 const Workers& workers);

} // namespace voroprobe
