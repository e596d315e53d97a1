#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "volume/height_field.h"

namespace voroprobe
{

//! One slice of samples with a rim of samples beyond the border around it, all of them outside. Columns and
//! rows are counted from -1 to the number of samples, both included.
class PaddedSlice
{
public:
    PaddedSlice(int columns, int rows)
        : columns_(columns), rows_(rows),
          heights_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)),
          sides_(static_cast<std::size_t>(columns + 2) * static_cast<std::size_t>(rows + 2))
    {
    }

    //! Slice k of the field; one beyond the border where the field has no such slice.
    void read(const HeightField& field, int k)
    {
        const bool exists = k >= 0 && k < field.frame().sample_count[2];
        if (exists)
            field.read_slice(static_cast<std::size_t>(k), heights_);
        for (int j = 0; j < rows_; ++j)
            note_sides(j, exists);
    }

    //! \pre (i, j) is not in the rim.
    [[nodiscard]] double height(int i, int j) const
    {
        return heights_[static_cast<std::size_t>(i) +
                        static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_)];
    }

    //! For each column i of row j but the last: bit 0 where sample i is inside, bit 1 where i + 1 is. The
    //! pointer is to column -1.
    [[nodiscard]] const std::uint8_t* pair_row(int j) const { return sides_.data() + row_offset(j); }

private:
    [[nodiscard]] std::size_t row_offset(int j) const
    {
        return static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(columns_ + 2);
    }

    void note_sides(int j, bool exists)
    {
        const auto count = static_cast<std::size_t>(columns_);
        const double* heights = heights_.data() + static_cast<std::size_t>(j) * count;
        std::uint8_t* sides = sides_.data() + row_offset(j);
        for (std::size_t i = 0; i < count; ++i)
            sides[i + 1] = exists && heights[i] >= 0.0 ? 1 : 0;
        for (std::size_t i = 0; i <= count; ++i)
            sides[i] = static_cast<std::uint8_t>((sides[i] & 1U) | (sides[i + 1] & 1U) << 1U);
    }

    int columns_;
    int rows_;
    std::vector<double> heights_;
    std::vector<std::uint8_t> sides_;
};

//! Two slices in a row and the one before them, each read once while the window moves upwards.
class SliceWindow
{
public:
    //! Holds slices k and k + 1; -1 and the number of slices are beyond the border.
    SliceWindow(const HeightField& field, int k)
        : field_(field), k_(k), below_(field.frame().sample_count[0], field.frame().sample_count[1]),
          above_(below_), before_(below_)
    {
        below_.read(field_, k);
        above_.read(field_, k + 1);
    }

    void move_up()
    {
        std::swap(before_, below_);
        std::swap(below_, above_);
        ++k_;
        above_.read(field_, k_ + 1);
    }

    [[nodiscard]] int k() const { return k_; }

    //! Slice k - 1. \pre the window has moved up.
    [[nodiscard]] const PaddedSlice& before() const { return before_; }
    [[nodiscard]] const PaddedSlice& below() const { return below_; }
    [[nodiscard]] const PaddedSlice& above() const { return above_; }

private:
    const HeightField& field_;
    int k_;
    PaddedSlice below_;
    PaddedSlice above_;
    PaddedSlice before_;
};

} // namespace voroprobe
