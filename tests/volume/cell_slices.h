#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/union_find.h"
#include "volume/trilinear_cell.h"

namespace voroprobe
{

//! Slow and obvious: the topology of {interpolant >= 0} in one grid cell, by its slices across x. In a slice
//! the interpolant is bilinear: its parts hold corners, and opposite ones are joined by the sign of ad - bc.
//! That changes only where a corner, linear in x, or ad - bc, quadratic in x, is 0; slices between these say
//! all. \pre No two of them coincide: heights in general position.
class CellSlices
{
public:
    explicit CellSlices(const CellCorners& corners) : corners_(corners)
    {
        find_events();
        double low = 0.0;
        for (std::size_t i = 0; i <= events_.size(); ++i)
        {
            const double high = i < events_.size() ? events_[i].x : 1.0;
            slices_.push_back(slice_at(0.5 * (low + high)));
            low = high;
        }
    }

    //! Corner -> name of its part, which is its smallest corner.
    [[nodiscard]] std::array<std::uint8_t, 8> parts() const
    {
        // Nodes 0 to 7 are the grid cell's corners, then four for each slice.
        UnionFind sets(8 + 4 * slices_.size());
        const auto node = [](std::size_t slice, std::size_t m)
        { return static_cast<std::uint32_t>(8 + 4 * slice + m); };
        for (std::uint32_t m = 0; m < 4; ++m)
        {
            sets.unite(2 * m, node(0, m));
            sets.unite(2 * m + 1, node(slices_.size() - 1, m));
        }
        for (std::size_t s = 0; s < slices_.size(); ++s)
        {
            join_within(slices_[s],
                        [&](std::size_t a, std::size_t b) { sets.unite(node(s, a), node(s, b)); });
            for (std::size_t m = 0; m < 4 && s + 1 < slices_.size(); ++m)
                if ((slices_[s][m] >= 0.0) == (slices_[s + 1][m] >= 0.0))
                    sets.unite(node(s, m), node(s + 1, m));
        }
        std::array<std::uint8_t, 8> parts{};
        for (std::uint32_t corner = 0; corner < 8; ++corner)
            parts[corner] = static_cast<std::uint8_t>(sets.find(corner));
        return parts;
    }

    //! Euler characteristic, compactly supported, of the surface in the open grid cell: arcs in slices sum up
    //! to it over x, an open interval counting -1 and an event 1.
    [[nodiscard]] int surface_euler_characteristic() const
    {
        int sum = 0;
        for (std::size_t s = 0; s < slices_.size(); ++s)
            sum += arcs(slices_[s]);
        for (std::size_t i = 0; i < events_.size(); ++i)
        {
            const bool crosses = events_[i].is_saddle && arcs(slices_[i]) == 2; // a point and four open arcs
            sum -= crosses ? 3 : std::min(arcs(slices_[i]), arcs(slices_[i + 1]));
        }
        return sum;
    }

    //! Of a face or slice: corners 0 and 3 are opposite.
    using Square = std::array<double, 4>;

    //! Arcs of the surface in a square.
    [[nodiscard]] static int arcs(const Square& square)
    {
        int crossed = 0;
        for (const auto& [a, b] : kSides)
            crossed += (square[a] >= 0.0) != (square[b] >= 0.0) ? 1 : 0;
        return crossed / 2;
    }

    //! Calls `join` with corners of one part.
    template <class Join>
    static void join_within(const Square& square, Join join)
    {
        for (const auto& [a, b] : kSides)
            if ((square[a] >= 0.0) == (square[b] >= 0.0))
                join(a, b);
        if (arcs(square) != 2)
            return;
        const double saddle =
            (square[0] * square[3] - square[1] * square[2]) / (square[0] + square[3] - square[1] - square[2]);
        if ((saddle >= 0.0) == (square[0] >= 0.0))
            join(std::size_t{0}, std::size_t{3});
        else
            join(std::size_t{1}, std::size_t{2});
    }

private:
    struct Event
    {
        double x;
        bool is_saddle; //!< ad - bc is 0; else a corner is
    };

    static constexpr std::array<std::array<std::size_t, 2>, 4> kSides{{{0, 1}, {2, 3}, {0, 2}, {1, 3}}};

    [[nodiscard]] Square slice_at(double x) const
    {
        Square square{};
        for (std::size_t m = 0; m < 4; ++m)
            square[m] = (1.0 - x) * corners_[2 * m] + x * corners_[2 * m + 1];
        return square;
    }

    void find_events()
    {
        events_.reserve(6);
        Square at_0{};
        Square slope{};
        for (std::size_t m = 0; m < 4; ++m)
        {
            at_0[m] = corners_[2 * m];
            slope[m] = corners_[2 * m + 1] - corners_[2 * m];
            add_event(-at_0[m] / slope[m], false);
        }
        const double c0 = at_0[0] * at_0[3] - at_0[1] * at_0[2];
        const double c1 = at_0[0] * slope[3] + slope[0] * at_0[3] - at_0[1] * slope[2] - slope[1] * at_0[2];
        const double c2 = slope[0] * slope[3] - slope[1] * slope[2];
        const double discriminant = c1 * c1 - 4.0 * c0 * c2;
        if (discriminant > 0.0)
        {
            const double half = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
            add_event(half / c2, true);
            add_event(c0 / half, true);
        }
        std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) { return a.x < b.x; });
    }

    void add_event(double x, bool is_saddle)
    {
        if (x > 0.0 && x < 1.0)
            events_.push_back({x, is_saddle});
    }

    CellCorners corners_;
    std::vector<Event> events_;
    std::vector<Square> slices_; //!< one before, one between, one after the events
};

} // namespace voroprobe
