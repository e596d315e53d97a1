#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/euler_sums.h"
#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! Delaunay cells that changed region together, to open or close a bridge or a tunnel.
struct HandleChange
{
    std::vector<DelaunayCell> cells;
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

//! By surface of the oracle's inventory: twice what the Euler characteristic of its mesh lacks, by the
//! regions of the Delaunay cells. Negative where handles are missing, positive where there are too many.
//! Cost: O(Delaunay cells).
std::vector<long> lacking_euler(const RestrictedDelaunay& restricted);

//! Opens bridges and tunnels that the scan has and the mesh has not, and closes those that the mesh has and
//! the scan has not: where a neck of the scan lies on the wrong side of the mesh, the Delaunay cells along it
//! change region. Each change is kept only if it brings the Euler characteristics nearer to the inventory's,
//! no regions meet that do not in the scan, every region stays connected, and no facet that it makes has a
//! side longer than `longest_side` (scan units).
//!
//! To be called after repair_regions(). `lacking`: as above; brought up to date. Cost: that of the pieces of
//! the mesh around the necks on surfaces that lack something.
HandleRepairReport repair_handles(RestrictedDelaunay& restricted, std::span<const Neck> necks,
                                  double longest_side, std::vector<long>& lacking);

//! The same for single cells next to surfaces with too many handles, where they lie in the region beyond the
//! surface. Cost: O(Delaunay cells).
std::vector<HandleChange> repair_slivers(RestrictedDelaunay& restricted, double longest_side,
                                         std::vector<long>& lacking);

//! Gives the cells their former regions again.
void undo(const HandleChange& change);

} // namespace voroprobe
