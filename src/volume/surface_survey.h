#pragma once

#include <cstddef>
#include <vector>

#include "geometry/box3.h"
#include "volume/height_field.h"
#include "volume/inventory.h"

namespace voroprobe
{

//! What is summed up over the grid cells that a surface passes.
struct SurfaceMeasure
{
    Box3 box;                          //!< of the crossings with grid edges, and of the caps' samples
    Point3 first_crossing;             //!< with a grid edge, the lowest (z, then y, then x)
    bool has_crossing = false;         //!< false: it consists of caps alone
    bool touches_border = false;       //!< it has caps
    std::ptrdiff_t euler_quarters = 0; //!< four times its Euler characteristic
};

//! Measures all surfaces of an inventory that knows its regions and their neighbours. One pass over the
//! samples.
std::vector<SurfaceMeasure> measure_surfaces(const HeightField& field, const Inventory& inventory,
                                             std::size_t threads);

} // namespace voroprobe
