#include "volume/volume.h"

#include <string>
#include <utility>

#include "support/error.h"

namespace voroprobe
{

namespace
{

//! Number of samples of a lattice; 0 where the product does not fit a std::size_t.
std::size_t product_or_zero(const std::array<std::size_t, 3>& size)
{
    std::size_t product = 1;
    for (const std::size_t n : size)
        if (__builtin_mul_overflow(product, n, &product))
            return 0;
    return product;
}

void require_matching_count(const StoredLattice& lattice, std::size_t found)
{
    if (found == 0 || product_or_zero(lattice.size) != found)
        throw InputError(std::to_string(found) + " samples, expected " + std::to_string(lattice.size[0]) +
                         " x " + std::to_string(lattice.size[1]) + " x " + std::to_string(lattice.size[2]));
}

template <class Sample>
std::vector<Sample> reorder(const std::vector<Sample>& stored, const std::array<std::size_t, 3>& stored_size,
                            const AxisOrder& order)
{
    const std::array<std::ptrdiff_t, 3> stored_stride{
        1, static_cast<std::ptrdiff_t>(stored_size[0]),
        static_cast<std::ptrdiff_t>(stored_size[0] * stored_size[1])};
    std::array<std::size_t, 3> size{};
    std::array<std::ptrdiff_t, 3> stride{};
    std::ptrdiff_t first = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const std::size_t from = order.stored_axis[axis];
        size[axis] = stored_size[from];
        stride[axis] = order.reversed[axis] ? -stored_stride[from] : stored_stride[from];
        if (order.reversed[axis])
            first += static_cast<std::ptrdiff_t>(size[axis] - 1) * stored_stride[from];
    }

    std::vector<Sample> canonical;
    canonical.reserve(stored.size());
    for (std::size_t k = 0; k < size[2]; ++k)
        for (std::size_t j = 0; j < size[1]; ++j)
        {
            std::ptrdiff_t at = first + static_cast<std::ptrdiff_t>(k) * stride[2] +
                                static_cast<std::ptrdiff_t>(j) * stride[1];
            for (std::size_t i = 0; i < size[0]; ++i, at += stride[0])
                canonical.push_back(stored[static_cast<std::size_t>(at)]);
        }
    return canonical;
}

} // namespace

std::string_view sample_type_name(const SampleArray& samples)
{
    static constexpr std::array<std::string_view, std::variant_size_v<SampleArray>> kNames{
        "uint8", "int8", "uint16", "int16", "int32", "float32", "float64"};
    return kNames[samples.index()];
}

double Volume::at(std::size_t i, std::size_t j, std::size_t k) const
{
    const std::size_t offset = i + geometry.size[0] * (j + geometry.size[1] * k);
    return std::visit([offset](const auto& values) { return static_cast<double>(values[offset]); }, samples);
}

Volume make_volume(const StoredLattice& lattice, SampleArray samples)
{
    const AxisOrder order = canonical_axis_order(lattice.direction);
    Volume volume;
    volume.geometry = make_grid_geometry(lattice, order);
    require_matching_count(lattice, std::visit([](const auto& values) { return values.size(); }, samples));
    if (order.is_identity())
        volume.samples = std::move(samples);
    else
        volume.samples = std::visit(
            [&](const auto& values) -> SampleArray { return reorder(values, lattice.size, order); }, samples);
    return volume;
}

} // namespace voroprobe
