#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "volume/height_field.h"
#include "volume/region.h"

namespace voroprobe
{

//! A maximal row of samples of one side: it begins at `first` and ends where the next of its row begins.
struct Run
{
    std::int32_t first;
    Region region;
};

//! The regions of all samples of a scan, as runs along x. Memory: 8 bytes per run, well below 1 byte per
//! sample for scans and 4 for white noise.
class RegionRuns
{
public:
    RegionRuns() = default;

    //! Numbers the regions of {height >= 0} 1, 2, ... and those of {height < 0} -1, -2, ..., both in the
    //! order of their first samples (k, j, i); -1 is what lies beyond the border and all that is joined to
    //! it. Cost: three passes over the samples, near-linear in the runs. \throw InputError for 2^31 runs or
    //! more.
    RegionRuns(const HeightField& field, std::size_t threads);

    [[nodiscard]] const std::array<int, 3>& sample_count() const { return size_; }

    //! The runs of the row of samples (., j, k), at least one.
    [[nodiscard]] std::span<const Run> row(int j, int k) const
    {
        const std::size_t at = row_index(j, k);
        return {runs_.data() + row_begin_[at], row_begin_[at + 1] - row_begin_[at]};
    }

    //! The region of sample (i, j, k); kOuterRegion beyond the border. Cost: O(log runs of the row).
    [[nodiscard]] Region region(int i, int j, int k) const;

    [[nodiscard]] std::size_t memory_bytes() const
    {
        return runs_.size() * sizeof(Run) + row_begin_.size() * sizeof(std::size_t);
    }

private:
    [[nodiscard]] std::size_t row_index(int j, int k) const
    {
        return static_cast<std::size_t>(j) + static_cast<std::size_t>(k) * static_cast<std::size_t>(size_[1]);
    }

    void count_runs(const HeightField& field, std::size_t threads);
    void fill_runs(const HeightField& field, std::size_t threads);
    void join_runs(const HeightField& field, std::size_t threads);
    void number_regions();

    std::array<int, 3> size_{};
    std::vector<Run> runs_; //!< the first stands for what lies beyond the border
    std::vector<std::size_t> row_begin_;
};

} // namespace voroprobe
