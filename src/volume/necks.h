#pragma once

#include <vector>

#include "volume/height_field.h"
#include "volume/inventory.h"
#include "volume/neck.h"

namespace voroprobe
{

//! The necks of all regions: at saddles on the faces of grid cells whose diagonals lie on different sides,
//! and at samples without which the samples around them would be joined otherwise (those that are not simple
//! points). Those at body saddles, few, are left out. In the order of memory. Cost: two passes over the
//! samples.
//! Source of simple points: Bertrand & Malandain, A new characterization of three-dimensional simple points,
//! 1994; here both sides are joined along edges.
std::vector<Neck> find_necks(const HeightField& field, const Inventory& inventory);

} // namespace voroprobe
