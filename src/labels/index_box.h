#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace voroprobe
{

//! Indices of a sample along the axes of a canonical array; those beyond the border are allowed.
using SampleIndex = std::array<int, 3>;

//! A box of samples, `first` and `last` included; empty until something is included.
struct IndexBox
{
    SampleIndex first{1, 1, 1};
    SampleIndex last{0, 0, 0};

    [[nodiscard]] bool empty() const { return first[0] > last[0]; }

    void include(const SampleIndex& index)
    {
        if (empty())
            first = last = index;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            first[axis] = std::min(first[axis], index[axis]);
            last[axis] = std::max(last[axis], index[axis]);
        }
    }

    //! \pre neither is empty, here and below.
    void include(const IndexBox& box)
    {
        include(box.first);
        include(box.last);
    }

    [[nodiscard]] IndexBox grown(int samples) const
    {
        IndexBox box = *this;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            box.first[axis] -= samples;
            box.last[axis] += samples;
        }
        return box;
    }

    //! Whether the two have a sample in common.
    [[nodiscard]] bool meets(const IndexBox& box) const
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (first[axis] > box.last[axis] || box.first[axis] > last[axis])
                return false;
        return true;
    }

    [[nodiscard]] std::array<std::size_t, 3> size() const
    {
        std::array<std::size_t, 3> count{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            count[axis] = static_cast<std::size_t>(std::ptrdiff_t{last[axis]} - first[axis] + 1);
        return count;
    }

    [[nodiscard]] std::size_t sample_count() const
    {
        const auto [x, y, z] = size();
        return x * y * z;
    }
};

} // namespace voroprobe
