#pragma once

#include <span>

#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! Whether the given odd facets, all those around `vertex`, form one closed umbrella: their edges opposite
//! the vertex are one cycle. False for an empty set.
bool is_umbrella(const RestrictedDelaunay& restricted, VertexHandle vertex, std::span<const FacetId> facets);

} // namespace voroprobe
