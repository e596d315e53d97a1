#pragma once

#include <cstdint>

namespace voroprobe
{

//! Which part of space a point lies in: positive inside the object, negative outside, never 0. Without an
//! inventory +1 and -1; with one the region's id.
using Region = std::int32_t;

inline constexpr Region kOuterRegion = -1; //!< the outside that holds everything beyond the domain

inline bool is_inside(Region region)
{
    return region > 0;
}

//! A closed surface, by its place in the inventory; 0 is the only one where there is no inventory.
using SurfaceId = std::int32_t;

inline constexpr SurfaceId kNoSurface = -1;

//! The two regions that a surface separates; one of them lies within the other.
struct SurfaceSides
{
    Region inside;
    Region outside;
};

} // namespace voroprobe
