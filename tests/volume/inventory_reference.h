#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/random.h"
#include "support/union_find.h"
#include "tests/volume/cell_slices.h"
#include "volume/height_field.h"

namespace voroprobe
{

//! Slow and obvious: the regions of all samples by union-find over samples, grid cell by grid cell, and the
//! Euler characteristic of all surfaces together by the slices of grid cells.
class InventoryReference
{
public:
    using Index = std::array<int, 3>;

    //! `raise`: by up to twice this, samples are raised into general position. Where it is smaller than all
    //! saddles but those of value 0, these fall inside and all else stays.
    InventoryReference(const HeightField& field, double raise)
        : size_(field.frame().sample_count), heights_(count()), sets_(count() + 1)
    {
        Random random(11);
        const std::size_t slice = heights_.size() / static_cast<std::size_t>(size_[2]);
        for (std::size_t k = 0; k < static_cast<std::size_t>(size_[2]); ++k)
            field.read_slice(k, std::span(heights_).subspan(k * slice, slice));
        for (double& height : heights_)
            height += raise * random.uniform(1.0, 2.0);
        join_regions();
    }

    [[nodiscard]] std::size_t region_count()
    {
        std::size_t number = 0;
        for (std::uint32_t i = 0; i <= heights_.size(); ++i)
            number += sets_.find(i) == i ? 1 : 0;
        return number;
    }

    //! The name of the region of a sample, or of all beyond the border.
    [[nodiscard]] std::uint32_t region(const Index& index) { return sets_.find(node(index)); }

    [[nodiscard]] double height(const Index& index) const { return heights_[node(index)]; }

    //! Of all surfaces together, caps included: points, arcs and patches of them in the edges, faces and
    //! insides of grid cells; samples, edges and parts of squares of the caps.
    [[nodiscard]] long euler_characteristic() const
    {
        long sum = 0;
        for_each_index(
            [&](const Index& at)
            {
                sum += on_border(at, 0) && height(at) >= 0.0 ? 1 : 0;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    if (exists(moved(at, axis)))
                        sum += edge(at, axis);
                for (std::size_t axis = 0; axis < 3; ++axis)
                    if (exists(moved(moved(at, (axis + 1) % 3), (axis + 2) % 3)))
                        sum += square(at, axis);
                if (exists({at[0] + 1, at[1] + 1, at[2] + 1}))
                    sum += CellSlices(corners(at)).surface_euler_characteristic();
            });
        return sum;
    }

private:
    [[nodiscard]] std::size_t count() const
    {
        return static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
               static_cast<std::size_t>(size_[2]);
    }

    [[nodiscard]] bool exists(const Index& at) const
    {
        return at[0] >= 0 && at[1] >= 0 && at[2] >= 0 && at[0] < size_[0] && at[1] < size_[1] &&
               at[2] < size_[2];
    }

    //! The last is all beyond the border.
    [[nodiscard]] std::uint32_t node(const Index& at) const
    {
        return static_cast<std::uint32_t>(exists(at) ? at[0] + size_[0] * (at[1] + size_[1] * at[2])
                                                     : size_[0] * size_[1] * size_[2]);
    }

    [[nodiscard]] static Index moved(Index at, std::size_t axis)
    {
        ++at[axis];
        return at;
    }

    //! Does what spans the axes not in `spanned` (bits) from `at` lie in a face of the volume's box?
    [[nodiscard]] bool on_border(const Index& at, unsigned spanned) const
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if ((spanned >> axis & 1U) == 0 && (at[axis] == 0 || at[axis] + 1 == size_[axis]))
                return true;
        return false;
    }

    template <class Visit>
    void for_each_index(Visit visit) const
    {
        for (int k = 0; k < size_[2]; ++k)
            for (int j = 0; j < size_[1]; ++j)
                for (int i = 0; i < size_[0]; ++i)
                    visit(Index{i, j, k});
    }

    [[nodiscard]] static Index corner_of(const Index& at, std::size_t corner)
    {
        return {at[0] + static_cast<int>(corner & 1U), at[1] + static_cast<int>(corner >> 1U & 1U),
                at[2] + static_cast<int>(corner >> 2U)};
    }

    [[nodiscard]] CellCorners corners(const Index& at) const
    {
        CellCorners corners;
        for (std::size_t corner = 0; corner < 8; ++corner)
            corners[corner] = height(corner_of(at, corner));
        return corners;
    }

    void join_regions()
    {
        for_each_index(
            [&](const Index& at)
            {
                if (on_border(at, 0) && height(at) < 0.0)
                    sets_.unite(node(at), static_cast<std::uint32_t>(heights_.size()));
                if (!exists({at[0] + 1, at[1] + 1, at[2] + 1}))
                    return;
                const auto parts = CellSlices(corners(at)).parts();
                for (std::size_t corner = 0; corner < 8; ++corner)
                    sets_.unite(node(corner_of(at, corner)), node(corner_of(at, parts[corner])));
            });
    }

    [[nodiscard]] int edge(const Index& at, std::size_t axis) const
    {
        const bool a = height(at) >= 0.0;
        const bool b = height(moved(at, axis)) >= 0.0;
        return (a != b ? 1 : 0) - (on_border(at, 1U << axis) && (a || b) ? 1 : 0);
    }

    //! The square across `axis`.
    [[nodiscard]] int square(const Index& at, std::size_t axis) const
    {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        const CellSlices::Square heights{height(at), height(moved(at, u)), height(moved(at, v)),
                                         height(moved(moved(at, u), v))};
        const int arcs = CellSlices::arcs(heights);
        if (!on_border(at, 1U << u | 1U << v))
            return -arcs;
        UnionFind sets(4);
        CellSlices::join_within(heights,
                                [&](std::size_t a, std::size_t b) {
                                    sets.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
                                });
        int parts_inside = 0;
        for (std::uint32_t m = 0; m < 4; ++m)
            parts_inside += sets.find(m) == m && heights[m] >= 0.0 ? 1 : 0;
        return parts_inside - arcs;
    }

    Index size_;
    std::vector<double> heights_;
    UnionFind sets_;
};

} // namespace voroprobe
