#pragma once

#include <span>

#include "labels/interface_meshing.h"

namespace voroprobe
{

struct InterfaceFittingOptions
{
    //! A vertex ends no farther from where it was, scan units, > 0.
    double max_shift;

    //! Volumes that are as near to those wanted are left alone, as a share.
    double tolerance = 0.005;
};

//! Moves interfaces until each label has the volume wanted for it. Each label has a pressure; an interface
//! moves by the difference of those on its sides, vertices where several meet by what suits all of them best.
//! Faces stay as they are, so that neighbours keep the same triangles; vertices whose faces would cross or
//! turn over stay where they are. `wanted`: by label, that of the background is not looked at; cubic scan
//! units. \pre no faces cross. Cost: some rounds of O(n) and a test of crossing each. Deterministic.
void fit_volumes(InterfaceMesh& interfaces, std::span<const double> wanted,
                 const InterfaceFittingOptions& options);

} // namespace voroprobe
