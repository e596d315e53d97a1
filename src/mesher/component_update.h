#pragma once

#include <span>

#include "mesher/cell_table.h"
#include "mesher/region_components.h"

namespace voroprobe
{

//! Brings components up to date after some cells were made, or have changed region; by short searches around
//! them: a region whose cells around the changed ones are still joined is still whole. What has come apart is
//! a component of its own, the smaller of the two. False where the searches do not tell, or nothing of a
//! region is left where it was: then components have to be found anew.
//! `changed`: numbers of cells, each as often as you like. \pre Each region was in one piece before.
bool update_components(const CellTable& table, std::span<const CellTable::Number> changed,
                       RegionComponents& components);

} // namespace voroprobe
