#pragma once

#include <cstddef>
#include <cstdint>

#include "postprocess/bounding_surface.h"
#include "postprocess/face_patch.h"
#include "postprocess/patch_guard.h"
#include "postprocess/shift_bound.h"

namespace voroprobe
{

//! What was done to a mesh to raise its angles.
struct RelaxationCounts
{
    std::size_t flips = 0;
    std::size_t collapses = 0;
    std::size_t splits = 0;

    RelaxationCounts& operator+=(const RelaxationCounts& more);
};

//! A patch that changes have been made to.
struct ChangedPatch
{
    FacePatch patch;
    double shortfall; //!< of its angles, see FacePatch::shortfall()
    RelaxationCounts changes;
};

struct AnnealingOptions
{
    double goal_angle_deg; //!< what all angles are to have, degrees, in [0, 60]
    std::size_t steps;     //!< tried at most
    std::uint64_t seed;    //!< of their choice

    //! So many more faces may lie beyond the bound than in the patch before.
    std::size_t more_beyond = 0;

    double shift_share = 1.0; //!< of the bound on the shift that may be used, in (0, 1]

    //! By how much a step may raise the shortfall at first, squared degrees, > 0.
    double temperature;
};

//! Looks for a patch without short angles by random moves, flips, collapses and splits: at first also by such
//! that make angles smaller, in the end by those alone that help. After every step the guard would let the
//! patch take the place of `before`, and the bound on the shift holds. Vertices stay on the surface, but for
//! those on faces beyond the bound: the surface is not near them, and projecting on it would take them far
//! from where they were. \return the state with the least shortfall, among those with no smaller angle than
//! `before`; `before` itself where nothing was gained. Cost: some 20 microseconds a step. Source:
//! Kirkpatrick, Gelatt & Vecchi 1983, "Optimization by simulated annealing".
ChangedPatch anneal(const FacePatch& before, const BoundingSurface& surface, PatchGuard& guard,
                    const ShiftBound& shift_bound, const AnnealingOptions& options);

} // namespace voroprobe
