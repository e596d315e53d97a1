#pragma once

#include <vector>

#include "mesher/meshing_options.h"
#include "mesher/refinement.h"
#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! Points of the surface that are known beforehand, inserted only as far as the mesh needs them.
//!
//! Points closer together than the criteria ask would end up in clusters of small triangles (Feree & Alliez
//! 2009, Fig. 4). So candidates wait. The first is inserted, then those that keep a distance from all
//! vertices, which is halved from the domain's diagonal down to the floor; in between the mesher refines, and
//! what the mesh has come to is passed over. In the end every candidate is a vertex, within the reach of the
//! mesh, or within the floor of a vertex: nothing is left out that inserting all of them would have begun.
class SeedCandidates
{
public:
    //! All references must outlive the object.
    SeedCandidates(const RestrictedDelaunay& restricted, const MeshingOptions& options,
                   Refinement& refinement, MeshingStatistics& statistics);

    void add(const std::vector<Point3>& points);

    //! Inserts the next candidates; false where there are none left. At most log2(diagonal / floor) rounds,
    //! each O(candidates log n).
    bool insert_some();

private:
    void pass_over_meshed();

    const RestrictedDelaunay& restricted_;
    const MeshingOptions& options_;
    Refinement& refinement_;
    MeshingStatistics& statistics_;
    std::vector<Point3> waiting_;
    double separation_; //!< from all vertices, of the candidates to be inserted next
};

} // namespace voroprobe
