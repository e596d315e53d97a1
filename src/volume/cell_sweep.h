#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "volume/cell_topology.h"
#include "volume/region_runs.h"
#include "volume/slice_window.h"

namespace voroprobe
{

//! The runs of a row of samples, asked from left to right. Columns and rows beyond the border belong to one
//! run of its own, which the caller names.
class RowCursor
{
public:
    RowCursor() = default;
    RowCursor(std::span<const Run> row, const Run* beyond, int columns)
        : at_(row.data()), end_(row.data() + row.size()), beyond_(beyond), columns_(columns)
    {
    }

    //! The run of column i or i + 1. \pre i is at least that of the call before.
    [[nodiscard]] const Run* run(int i, bool next)
    {
        while (at_ + 1 < end_ && at_[1].first <= i)
            ++at_;
        const int column = next ? i + 1 : i;
        if (column < 0 || column >= columns_ || at_ == end_)
            return beyond_;
        return column > i && at_ + 1 < end_ && at_[1].first <= column ? at_ + 1 : at_;
    }

private:
    const Run* at_ = nullptr;
    const Run* end_ = nullptr;
    const Run* beyond_ = nullptr;
    int columns_ = 0;
};

//! A mixed grid cell met by a sweep; those that reach beyond the border count as well.
class SweptCell
{
public:
    SweptCell(const SliceWindow& slices, const std::array<int, 3>& size, int j)
        : slices_(slices), size_(size), j_(j)
    {
    }

    [[nodiscard]] CornerCode code() const { return code_; }
    [[nodiscard]] int i() const { return i_; } //!< of its lowest corner, from -1
    [[nodiscard]] int j() const { return j_; }
    [[nodiscard]] int k() const { return slices_.k(); }

    [[nodiscard]] bool reaches_beyond_border() const
    {
        return i_ < 0 || j_ < 0 || k() < 0 || i_ + 1 == size_[0] || j_ + 1 == size_[1] || k() + 1 == size_[2];
    }

    //! The run that holds a corner.
    [[nodiscard]] const Run* run(std::size_t corner)
    {
        return rows_[corner >> 1U].run(i_, (corner & 1U) != 0);
    }

    //! Is the corner a sample, not beyond the border?
    [[nodiscard]] bool is_sample(std::size_t corner) const
    {
        const auto [i, j, k] = index(corner);
        return i >= 0 && i < size_[0] && j >= 0 && j < size_[1] && k >= 0 && k < size_[2];
    }

    [[nodiscard]] std::array<int, 3> index(std::size_t corner) const
    {
        return {i_ + static_cast<int>(corner & 1U), j_ + static_cast<int>(corner >> 1U & 1U),
                k() + static_cast<int>(corner >> 2U)};
    }

    //! The heights of the corners; -1 beyond the border.
    [[nodiscard]] CellCorners heights() const
    {
        CellCorners heights;
        for (std::size_t corner = 0; corner < 8; ++corner)
            heights[corner] = is_sample(corner) ? height(corner) : -1.0;
        return heights;
    }

    //! \pre The corner is a sample.
    [[nodiscard]] double height(std::size_t corner) const
    {
        const auto [i, j, k] = index(corner);
        return (k == slices_.k() ? slices_.below() : slices_.above()).height(i, j);
    }

    [[nodiscard]] CellTopology topology() const
    {
        return reaches_beyond_border() ? connect_corners_on_faces(heights()) : connect_corners(heights());
    }

private:
    template <class Visit>
    friend class CellSweep;

    const SliceWindow& slices_;
    std::array<int, 3> size_;
    int i_ = 0;
    int j_;
    CornerCode code_ = 0;
    std::array<RowCursor, 4> rows_; //!< of corners 0, 2, 4 and 6
};

//! Calls `visit(SweptCell&)` for the mixed grid cells between two slices, in order, those that reach beyond
//! the border included.
template <class Visit>
class CellSweep
{
public:
    CellSweep(const RegionRuns& runs, const Run* beyond, Visit visit)
        : runs_(runs), beyond_(beyond), visit_(visit),
          codes_((static_cast<std::size_t>(runs.sample_count()[0]) + 1 + kWord) / kWord * kWord)
    {
    }

    void sweep(const SliceWindow& slices)
    {
        for (int j = -1; j < runs_.sample_count()[1]; ++j)
            sweep_row(slices, j);
    }

private:
    static constexpr std::size_t kWord = sizeof(std::uint64_t);

    void sweep_row(const SliceWindow& slices, int j)
    {
        gather_codes(slices, j);
        SweptCell cell(slices, runs_.sample_count(), j);
        cell.rows_ = {cursor(j, slices.k()), cursor(j + 1, slices.k()), cursor(j, slices.k() + 1),
                      cursor(j + 1, slices.k() + 1)};
        for (std::size_t first = 0; first < codes_.size(); first += kWord)
        {
            std::uint64_t word = 0;
            std::memcpy(&word, codes_.data() + first, kWord);
            if (word == 0 || word == ~std::uint64_t{0})
                continue;
            for (std::size_t at = first; at < first + kWord; ++at)
            {
                cell.code_ = codes_[at];
                if (cell.code_ == 0 || cell.code_ == 0xFF)
                    continue;
                cell.i_ = static_cast<int>(at) - 1;
                visit_(cell);
            }
        }
    }

    //! Eight sides per grid cell of a row; no grid cell beyond the last is mixed.
    void gather_codes(const SliceWindow& slices, int j)
    {
        const std::uint8_t* y0z0 = slices.below().pair_row(j);
        const std::uint8_t* y1z0 = slices.below().pair_row(j + 1);
        const std::uint8_t* y0z1 = slices.above().pair_row(j);
        const std::uint8_t* y1z1 = slices.above().pair_row(j + 1);
        const auto count = static_cast<std::size_t>(runs_.sample_count()[0]) + 1;
        CornerCode* codes = codes_.data(); // a local variable, for the loop to be done with vectors
        for (std::size_t i = 0; i < count; ++i)
            codes[i] = static_cast<CornerCode>(y0z0[i] | y1z0[i] << 2U | y0z1[i] << 4U | y1z1[i] << 6U);
    }

    [[nodiscard]] RowCursor cursor(int j, int k) const
    {
        const auto [columns, rows, slices] = runs_.sample_count();
        const bool exists = j >= 0 && j < rows && k >= 0 && k < slices;
        return {exists ? runs_.row(j, k) : std::span<const Run>(), beyond_, columns};
    }

    const RegionRuns& runs_;
    const Run* beyond_;
    Visit visit_;
    std::vector<CornerCode> codes_;
};

} // namespace voroprobe
