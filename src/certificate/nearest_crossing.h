#pragma once

#include <optional>
#include <vector>

#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! Whether the caps that close an object on the border of the domain count as surface.
enum class BorderCaps
{
    kCounted,
    kLeftOut
};

//! Looks for the surface around points, with segments only. Keeps a buffer: one per thread.
class NearestCrossing
{
public:
    struct Found
    {
        Crossing crossing;
        Vec3 direction; //!< of the segment that met it, unit
        double distance;
    };

    explicit NearestCrossing(const SurfaceOracle& oracle, BorderCaps caps = BorderCaps::kCounted)
        : oracle_(oracle), caps_(caps)
    {
    }

    //! The crossing nearest to `p` within `reach` on the line through it; nullopt where there is none. \pre
    //! `direction` is a unit vector.
    [[nodiscard]] std::optional<Found> along(const Point3& p, const Vec3& direction, double reach);

    //! A crossing near `p`: along `likely_normal`, both ways, within `first_reach`; then in 13 directions of
    //! the lattice as well, always farther up to `last_reach`; and what is found is improved by looking along
    //! the surface's own normal there. The distance is an upper bound of that to the surface, exact where the
    //! surface is flat. Cost: 1 to about 6 queries next to the surface.
    [[nodiscard]] std::optional<Found> near(const Point3& p, const Vec3& likely_normal, double first_reach,
                                            double last_reach);

private:
    [[nodiscard]] std::optional<Found> in_all_directions(const Point3& p, double reach);
    [[nodiscard]] Found projected(const Point3& p, Found found);
    [[nodiscard]] std::optional<Vec3> normal_at(const Point3& p, const Found& found);

    const SurfaceOracle& oracle_;
    BorderCaps caps_;
    std::vector<Crossing> crossings_;
};

} // namespace voroprobe
