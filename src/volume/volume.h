#pragma once

#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "volume/grid_geometry.h"

namespace voroprobe
{

//! Samples in the type they were stored in, x fastest, then y, then z. Integers wider than 16 bits are kept
//! as int32 where their values allow it and as double otherwise.
using SampleArray = std::variant<std::vector<std::uint8_t>, std::vector<std::int8_t>,
                                 std::vector<std::uint16_t>, std::vector<std::int16_t>,
                                 std::vector<std::int32_t>, std::vector<float>, std::vector<double>>;

//! "uint8", "int8", "uint16", "int16", "int32", "float32" or "float64".
std::string_view sample_type_name(const SampleArray& samples);

//! A scalar 3D image on its canonical grid (see GridGeometry). Rescale slope and intercept are already
//! applied.
struct Volume
{
    GridGeometry geometry;
    SampleArray samples;

    //! Sample (i, j, k) of the canonical array. For tests and reports; inner loops visit `samples`.
    [[nodiscard]] double at(std::size_t i, std::size_t j, std::size_t k) const;
};

//! Puts stored samples on their canonical grid; copies only where the axes have to be permuted or reversed.
//! Cost: O(samples). \throw InputError where the number of samples does not fit the lattice, and as
//! make_grid_geometry.
Volume make_volume(const StoredLattice& lattice, SampleArray samples);

} // namespace voroprobe
