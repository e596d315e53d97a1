#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "certificate/certificate.h"
#include "volume/inventory.h"

namespace voroprobe
{

//! Which surfaces of a scan are wanted. What lies within a surface that is dropped is dropped with it.
struct SurfaceSelection
{
    //! Surfaces that enclose less are dropped, cubed scan units.
    std::optional<double> min_enclosed_volume = std::nullopt;

    //! Of the surfaces of objects, cavities left out, only so many stay: those that enclose most.
    std::optional<std::size_t> keep_largest = std::nullopt;

    //! Objects are filled: cavities go, and what floats in them.
    bool drop_cavities = false;

    [[nodiscard]] bool keeps_all() const { return !min_enclosed_volume && !keep_largest && !drop_cavities; }
};

//! The surfaces to drop, by id, each with the reason. `voxel_volume`: cubed scan units. Of equal ones the
//! first is kept. Cost: O(n log n).
std::vector<DroppedSurface> surfaces_to_drop(std::span<const ScanSurface> surfaces, double voxel_volume,
                                             const SurfaceSelection& selection);

} // namespace voroprobe
