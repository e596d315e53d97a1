#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mesher/delaunay.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! A Delaunay facet whose dual Voronoi edge meets the surface.
struct RestrictedFacet
{
    Point3 center;                //!< of the surface Delaunay ball: where the dual edge crosses the surface
    double squared_radius = 0.0;  //!< of the surface Delaunay ball
    DelaunayCell delaunay_cell{}; //!< the facet is the one opposite ...
    std::uint8_t index = 0;       //!< ... this vertex of the Delaunay cell
    bool kept = false;            //!< rounding hides the conflict of its center: not refined any more

    //! Crossings of the dual edge, capped at 255 with the parity kept; 0: the slot is free.
    std::uint8_t crossing_count = 0;
    std::array<std::uint32_t, 3> vertices{}; //!< indices of the corners
    std::uint32_t generation = 0;            //!< changes whenever the slot is reused or the facet recomputed

    //! Odd facets separate inside from outside: they are the mesh. Even ones are evidence of unresolved
    //! surface.
    [[nodiscard]] bool odd() const { return (crossing_count & 1U) != 0; }
};

//! Counts the crossings of a facet's dual edge and makes one of them the center: of several the one with the
//! largest ball, the farthest from what is resolved already. `corner`: any of the facet's.
inline void set_crossings(RestrictedFacet& facet, std::span<const Crossing> crossings, const Point3& corner)
{
    const std::size_t count = crossings.size();
    facet.crossing_count = static_cast<std::uint8_t>(count <= 255 ? count : 254 + (count & 1U));
    facet.squared_radius = -1.0;
    for (const Crossing& crossing : crossings)
    {
        const double squared_radius = squared_distance(crossing.point, corner);
        if (squared_radius > facet.squared_radius)
        {
            facet.squared_radius = squared_radius;
            facet.center = crossing.point;
        }
    }
}

} // namespace voroprobe
