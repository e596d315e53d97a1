#pragma once

#include <optional>

#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! probe(Omega): long parallel probes along the longest side of the oracle's domain, the central axis first,
//! each next one where the nearest earlier one is farthest, until one crosses the surface or every point of
//! the domain is within `spacing` of a probe. Returns the first crossing; nullopt when no probe met the
//! surface. Adds the queries made to `query_count`. Cost: at most about A / (2 spacing^2) queries for the
//! smallest side A of the domain. Source: Feree & Alliez 2009, Sec. 4.
std::optional<Point3> probe_domain(const SurfaceOracle& oracle, double spacing, std::size_t& query_count);

} // namespace voroprobe
