#pragma once

#include <optional>

#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! probe(Omega): long parallel probes along the longest side of the oracle's domain, the central axis first
//! and then level by level where the earlier ones are farthest, until one crosses the surface or every point
//! of the domain is within `spacing` of a probe. Returns the first crossing; nullopt when no probe met the
//! surface. Adds the queries made to `query_count`. Cost: about A / (2 spacing^2) to 2 A / spacing^2 queries
//! at most for the smallest side A of the domain. Source: Feree & Alliez 2009, Sec. 4. \throw UsageError
//! where that would be more than 2^28 queries.
std::optional<Point3> probe_domain(const SurfaceOracle& oracle, double spacing, std::size_t& query_count);

} // namespace voroprobe
