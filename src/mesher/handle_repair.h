#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "mesher/cell_table.h"
#include "mesher/euler_sums.h"
#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! Delaunay cells that changed region together, to open or close a bridge or a tunnel.
struct HandleChange
{
    std::vector<CellTable::Number> cells;
    std::vector<Region> former_regions; //!< of each cell
    DoubledEuler gained;                //!< by surface
};

//! A neck at which a change would help, were the Delaunay cells smaller.
struct CoarseNeck
{
    Neck neck;
    double longest_side; //!< of the facets that the change would make
};

struct HandleRepairReport
{
    std::vector<HandleChange> changes;
    std::vector<CoarseNeck> too_coarse;
    std::vector<Neck> of_no_help; //!< that lie on the wrong side, but alone make no handle right
};

//! What giving some cells to a region would do.
struct TriedChange
{
    DoubledEuler gained;
    //! No regions would meet that do not in the scan, and all stay connected. Unset where the number of
    //! handles gained nothing.
    std::optional<bool> is_possible;
    double longest_side = 0.0; //!< of the facets made, where it is possible
};

//! What the Delaunay cells along a neck would do, as long as nothing changes around them.
struct NeckTrial
{
    static constexpr auto kNoCell = std::numeric_limits<CellTable::Number>::max();

    CellTable::Number holder = kNoCell; //!< of its middle; kNoCell: not looked for
    std::vector<CellTable::Number> cells;
    TriedChange change;
    std::uint32_t tried_at = 0; //!< by HandleMemory::now; 0: not yet
};

//! What is known from one call to the next. All but the necks begins empty with each table.
struct HandleMemory
{
    std::vector<Neck> necks;               //!< of the scan
    std::vector<NeckTrial> trials;         //!< by neck
    std::uint32_t now = 1;                 //!< counts
    std::vector<std::uint32_t> changed_at; //!< by vertex: when a cell at it changed last
    std::size_t changes_seen = 0;          //!< of the table
};

//! After CellTable::update(), which has returned `new_cells`.
void note_new_cells(const CellTable& table, std::span<const CellTable::Number> new_cells,
                    HandleMemory& memory);

//! By surface of the oracle's inventory: twice what the Euler characteristic of its mesh lacks. Negative
//! where handles are missing, positive where there are too many.
std::vector<long> lacking_euler(const SurfaceOracle& oracle, std::vector<long> doubled_euler);

//! Opens bridges and tunnels that the scan has and the mesh has not, and closes those that the mesh has and
//! the scan has not: where a neck of the scan lies on the wrong side of the mesh, the Delaunay cells along it
//! change region. Each change is kept only if it brings the Euler characteristics nearer to the inventory's,
//! no regions meet that do not in the scan, every region stays connected, and no facet that it makes has a
//! side longer than `longest_side` (scan units).
//!
//! To be called after repair_regions(). `lacking`: as above; brought up to date. Cost: that of the pieces of
//! the mesh around the necks on surfaces that lack something, where these have changed since the last call.
HandleRepairReport repair_handles(const RestrictedDelaunay& restricted, CellTable& table,
                                  HandleMemory& memory, double longest_side, std::vector<long>& lacking);

//! The same for single cells next to surfaces with too many handles, where they lie in the region beyond the
//! surface. Cost: O(Delaunay cells).
std::vector<HandleChange> repair_slivers(const RestrictedDelaunay& restricted, CellTable& table,
                                         HandleMemory& memory, double longest_side,
                                         std::vector<long>& lacking);

//! Gives the cells their former regions again.
void undo(const HandleChange& change, CellTable& table);

} // namespace voroprobe
