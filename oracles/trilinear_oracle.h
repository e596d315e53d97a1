#pragma once

#include <memory>

#include "oracles/surface_oracle.h"
#include "volume/height_field.h"
#include "volume/inventory.h"
#include "volume/level.h"
#include "volume/volume.h"

namespace voroprobe
{

//! The exact isosurface of the trilinear interpolant of a volume, closed by the faces of the volume's box;
//! frame: grid.
//!
//! Samples equal to the isovalue are moved inside by an amount far below any that could be seen (simulation
//! of simplicity: one fixed side, everywhere the same). NaN and infinite samples count as outside. Empty
//! space is skipped by bricks of 4x4x4 grid cells that know their distance to the nearest brick with a
//! crossing. Memory: about 2 bits per sample beside the volume, which is shared, not copied (it is copied
//! where samples are not finite).
std::unique_ptr<SurfaceOracle> make_trilinear_oracle(std::shared_ptr<const Volume> volume, double isovalue,
                                                     InsideIs inside = InsideIs::kAbove);

//! The same with the regions and surfaces of an inventory, which is that of make_height_field(levelled) and
//! may be null. Memory: one bit per sample more. \throw UsageError where the inventory is of another size.
std::unique_ptr<SurfaceOracle> make_trilinear_oracle(const LevelledVolume& levelled,
                                                     std::shared_ptr<const Inventory> inventory);

} // namespace voroprobe
