#pragma once

#include <optional>
#include <vector>

#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! Tells the caps on the border of the domain from the surface itself, at places that lie near either.
class CapFinder
{
public:
    explicit CapFinder(const SurfaceOracle& oracle) : oracle_(oracle) {}

    //! The crossing nearest to p on the line through it along `direction`, a unit vector, at most `reach`
    //! (scan units) away. Cost: a query.
    [[nodiscard]] std::optional<Crossing> nearest(const Point3& p, const Vec3& direction, double reach);

private:
    const SurfaceOracle& oracle_;
    std::vector<Crossing> crossings_; // kept for its memory
};

} // namespace voroprobe
