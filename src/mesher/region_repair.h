#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/vec3.h"
#include "mesher/cell_table.h"
#include "mesher/region_components.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! What repair_regions() changed, in Delaunay cells.
struct RegionRepairReport
{
    std::size_t cells_reconciled = 0; //!< moved to a region that is a neighbour of those around
    std::size_t crumbs_dissolved = 0; //!< pieces of a region where the region is not
    std::size_t necks_bridged = 0;    //!< pieces of a region joined to the rest of it
    std::size_t pieces_left_apart = 0;
};

//! What is known of a table's regions from one call to the next. Begins empty with each table.
struct RegionRepairMemory
{
    bool looked_at_all = false;
    std::vector<CellTable::Number> changed;     //!< by others since the last call, and new cells
    std::vector<CellTable::Number> suspects;    //!< next to regions that do not touch theirs in the scan
    std::size_t changes_seen = 0;               //!< of the table
    std::optional<RegionComponents> components; //!< unset: have to be found anew
    std::vector<std::uint32_t> given_up; //!< indices of vertices around which no inside region may be joined
};

//! To be called before CellTable::update() ...
void note_changes(const CellTable& table, RegionRepairMemory& memory);

//! ... and after it, with what it has returned.
void note_new_cells(const CellTable& table, const std::vector<CellTable::Number>& new_cells,
                    RegionRepairMemory& memory);

//! Where the cheapest ways lead that would join the pieces of the regions: necks of the scan that the mesh
//! does not have, or not yet. Cost: O(Delaunay cells).
std::vector<Point3> find_gaps(const SurfaceOracle& oracle, CellTable& table, double floor_radius,
                              RegionRepairMemory& memory);

//! Makes the regions of the Delaunay cells what the oracle's inventory says they are, where refinement ended
//! at its floor before they were: each region one set of cells joined through facets, next to its neighbours
//! in the inventory's tree only. Then the pieces of the mesh and the surfaces of the inventory correspond one
//! to one.
//!
//! Any assignment of cells to regions bounds closed surfaces that do not cross, so cells may change region
//! freely; they do where that leaves fewer facets between regions that do not touch in the scan, where a
//! piece lies where its region is not (a sliver whose circumcenter is far away), and along the cheapest way
//! between two pieces of a region that the scan joins by a neck thinner than the floor. Cost: O(Delaunay
//! cells) where regions can have come apart since the last call, otherwise that of what has changed.
RegionRepairReport repair_regions(const SurfaceOracle& oracle, CellTable& table, double floor_radius,
                                  RegionRepairMemory& memory);

} // namespace voroprobe
