#pragma once

#include <cstddef>
#include <vector>

#include "mesher/meshing_options.h"
#include "mesher/refinement.h"
#include "mesher/region_settlement.h"
#include "mesher/restricted_delaunay.h"
#include "mesher/seeded_mesher.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! Follows up what the inventory of the scan lists and refinement has not meshed: surfaces, parts of them,
//! necks. Each call is a round, which inserts points and lowers the floor; it is for the caller to refine
//! then. Does nothing where the oracle has no inventory, or options ask for the paper's partial versions.
//! Source: docs/certificate.md, "How the labels come right", steps 2, 3, 5 and 6.
class InventoryPursuit
{
public:
    //! All arguments must outlive the object.
    InventoryPursuit(RestrictedDelaunay& restricted, const MeshingOptions& options, Refinement& refinement,
                     RegionSettlement& settlement, MeshingStatistics& statistics)
        : restricted_(restricted), options_(options), refinement_(refinement), settlement_(settlement),
          statistics_(statistics)
    {
    }

    //! Gives points to surfaces of the inventory without facets, and lowers the floor where facets do not lie
    //! on one surface or a region is in pieces. False when there is nothing left to refine.
    bool insert_into_missing_surfaces();

    //! Gives points to surfaces that refinement has lost again, to parts of surfaces that the mesh does not
    //! come to, and to the necks of the scan that labels alone could not put right, half as far apart in each
    //! round: a region as thin as a hair holds together where its two sides have points as close. Lowers the
    //! floor there, if that is not the first time, and where a region is in pieces. False where there is no
    //! such place. \pre The regions are settled; they are unsettled where it returns true.
    bool insert_at_flaws();

private:
    [[nodiscard]] bool is_wanted() const;
    [[nodiscard]] std::vector<Point3> flawed_points(double spacing) const;
    void find_uncovered();

    RestrictedDelaunay& restricted_;
    const MeshingOptions& options_;
    Refinement& refinement_;
    RegionSettlement& settlement_;
    MeshingStatistics& statistics_;
    int inventory_round_ = 0;
    int flaw_round_ = 0;
    std::size_t unfaithful_places_ = 0;   //!< when last looked for
    std::vector<SurfacePoint> uncovered_; //!< points that the mesh did not come to when last looked for
    bool flaws_yield_ = true;             //!< something could be done about the last ones
};

} // namespace voroprobe
