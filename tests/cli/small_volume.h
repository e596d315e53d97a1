#pragma once

#include <functional>

#include "volume/volume.h"

namespace voroprobe
{

//! A volume on the identity lattice with samples from a function of the index.
template <typename Sample>
Volume small_volume(const std::array<std::size_t, 3>& size,
                    const std::function<Sample(std::size_t, std::size_t, std::size_t)>& sample_at)
{
    std::vector<Sample> samples;
    samples.reserve(size[0] * size[1] * size[2]);
    for (std::size_t k = 0; k < size[2]; ++k)
        for (std::size_t j = 0; j < size[1]; ++j)
            for (std::size_t i = 0; i < size[0]; ++i)
                samples.push_back(sample_at(i, j, k));
    return make_volume({.size = size, .spacing = {1, 1, 1}, .direction = {}, .origin = {}},
                       std::move(samples));
}

} // namespace voroprobe
