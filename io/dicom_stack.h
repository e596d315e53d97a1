#pragma once

#include <string>
#include <vector>

#include "io/volume_samples.h"
#include "volume/grid_geometry.h"

//! Inside of io/: how DICOM slices make a volume (PS3.3 C.7.6.2, Image Plane).
namespace voroprobe
{

//! What the header of a slice says.
struct Slice
{
    std::string file;
    StoredLattice lattice;
    StoredType type;         //!< of the values, slope and intercept applied
    std::string stored_type; //!< of the file
    bool has_position = true;
};

//! Orders slices by their position along their common normal; never by name.
void order_by_position(std::vector<Slice>& slices);

//! The lattice of slices in order. \throw InputError that names the place where two slices share a position,
//! one is missing or the distances are seriously unequal, or where a tilted gantry shifts the slices
//! sideways. Slight cases are warnings.
StoredLattice stack_lattice(const std::vector<Slice>& slices, std::vector<std::string>& warnings);

} // namespace voroprobe
