#include "volume/region_runs.h"

#include <algorithm>
#include <limits>
#include <string>

#include "support/error.h"
#include "volume/cell_sweep.h"
#include "volume/run_joiner.h"
#include "volume/slabs.h"

namespace voroprobe
{
namespace
{

using RunNumber = RunJoiner::RunNumber;

//! Calls `begin(i)` for every run of a row of samples.
template <class Begin>
void for_each_run(std::span<const double> heights, Begin begin)
{
    bool inside = !(heights[0] >= 0.0);
    for (std::size_t i = 0; i < heights.size(); ++i)
        if ((heights[i] >= 0.0) != inside)
        {
            inside = !inside;
            begin(i);
        }
}

//! Calls `visit(k, heights)` for every slice, several at once.
template <class Visit>
void for_each_slice(const HeightField& field, std::size_t threads, Visit visit)
{
    const auto [columns, rows, slices] = field.frame().sample_count;
    const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    for_each_slab(static_cast<std::size_t>(slices), threads,
                  [&](std::size_t begin, std::size_t end)
                  {
                      std::vector<double> heights(count);
                      for (std::size_t k = begin; k < end; ++k)
                      {
                          field.read_slice(k, heights);
                          visit(k, std::span<const double>(heights));
                      }
                  });
}

//! The numbers of the runs of a row: from `begin` to before `end`.
struct RunRange
{
    RunNumber begin;
    RunNumber end;
};

//! Joins runs of one side: neighbours along y and z, diagonals of grid cells, and what reaches the border.
class Neighbourhood
{
public:
    //! Run 0 stands for what lies beyond the border.
    static constexpr RunNumber kBeyondBorder = 0;

    Neighbourhood(const RegionRuns& runs, std::vector<Run>& all) : runs_(runs), all_(all), joiner_(all.data())
    {
    }

    //! Rows of slice k with those next to them in it, and with what lies beyond the border.
    void join_within_slice(int k)
    {
        const auto [columns, rows, slices] = runs_.sample_count();
        for (int j = 0; j < rows; ++j)
        {
            if (j + 1 < rows)
                join_side_by_side(range(j, k), range(j + 1, k));
            if (j == 0 || j + 1 == rows || k == 0 || k + 1 == slices)
                join_side_by_side(range(j, k), {kBeyondBorder, kBeyondBorder + 1});
            else
                join_ends_with_outside(range(j, k));
        }
    }

    //! Rows of one slice with those of the next, and across the grid cells between.
    void join_across_layer(const SliceWindow& slices)
    {
        for (int j = 0; j < runs_.sample_count()[1]; ++j)
            join_side_by_side(range(j, slices.k()), range(j, slices.k() + 1));
        const auto join_in_cell = [this](SweptCell& cell)
        {
            if (!topology_of(cell.code()).simple)
                join_diagonals(cell);
        };
        CellSweep(runs_, &all_[kBeyondBorder], join_in_cell).sweep(slices);
    }

private:
    [[nodiscard]] RunNumber number(const Run* run) const { return static_cast<RunNumber>(run - all_.data()); }

    [[nodiscard]] RunRange range(int j, int k) const
    {
        const std::span<const Run> row = runs_.row(j, k);
        const RunNumber begin = number(row.data());
        return {begin, begin + static_cast<RunNumber>(row.size())};
    }

    //! Where the run after `run` begins.
    [[nodiscard]] int end_of(RunNumber run, const RunRange& row) const
    {
        return run + 1 < row.end ? all_[static_cast<std::size_t>(run) + 1].first
                                 : std::numeric_limits<int>::max();
    }

    void join_side_by_side(const RunRange& row_a, const RunRange& row_b)
    {
        RunNumber a = row_a.begin;
        RunNumber b = row_b.begin;
        while (a < row_a.end && b < row_b.end)
        {
            if (joiner_.inside(a) == joiner_.inside(b))
                joiner_.join(a, b);
            const int end_a = end_of(a, row_a);
            const int end_b = end_of(b, row_b);
            a += end_a <= end_b ? 1 : 0;
            b += end_b <= end_a ? 1 : 0;
        }
    }

    void join_ends_with_outside(const RunRange& row)
    {
        for (const RunNumber run : {row.begin, row.end - 1})
            if (!joiner_.inside(run))
                joiner_.join(run, kBeyondBorder);
    }

    void join_diagonals(SweptCell& cell)
    {
        const CornerParts parts = cell.topology().in_cell;
        for (std::size_t corner = 0; corner < 8; ++corner)
            if (parts[corner] != corner)
                joiner_.join(number(cell.run(corner)), number(cell.run(parts[corner])));
    }

    const RegionRuns& runs_;
    std::vector<Run>& all_;
    RunJoiner joiner_;
};

} // namespace

RegionRuns::RegionRuns(const HeightField& field, std::size_t threads) : size_(field.frame().sample_count)
{
    count_runs(field, threads);
    fill_runs(field, threads);
    join_runs(field, threads);
    number_regions();
}

void RegionRuns::count_runs(const HeightField& field, std::size_t threads)
{
    const auto columns = static_cast<std::size_t>(size_[0]);
    row_begin_.resize(static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(size_[2]) + 1);
    for_each_slice(field, threads,
                   [&](std::size_t k, std::span<const double> heights)
                   {
                       for (int j = 0; j < size_[1]; ++j)
                       {
                           const double* row = heights.data() + static_cast<std::size_t>(j) * columns;
                           std::size_t changes = 0;
                           for (std::size_t i = 1; i < columns; ++i)
                               changes += (row[i - 1] >= 0.0) != (row[i] >= 0.0) ? 1 : 0;
                           row_begin_[row_index(j, static_cast<int>(k)) + 1] = changes + 1;
                       }
                   });
    row_begin_[0] = 1;
    for (std::size_t row = 0; row + 1 < row_begin_.size(); ++row)
        row_begin_[row + 1] += row_begin_[row];
    if (row_begin_.back() >= static_cast<std::size_t>(std::numeric_limits<RunNumber>::max()))
        throw InputError("inventory of surfaces: the isovalue cuts the rows of samples into " +
                         std::to_string(row_begin_.back()) + " runs, expected fewer than 2^31");
}

void RegionRuns::fill_runs(const HeightField& field, std::size_t threads)
{
    const auto columns = static_cast<std::size_t>(size_[0]);
    runs_.resize(row_begin_.back());
    runs_[0] = {0, kOuterRegion};
    for_each_slice(
        field, threads,
        [&](std::size_t k, std::span<const double> heights)
        {
            for (int j = 0; j < size_[1]; ++j)
            {
                const auto row = heights.subspan(static_cast<std::size_t>(j) * columns, columns);
                auto number = static_cast<RunNumber>(row_begin_[row_index(j, static_cast<int>(k))]);
                for_each_run(row,
                             [&](std::size_t i)
                             {
                                 runs_[static_cast<std::size_t>(number)] = {
                                     static_cast<std::int32_t>(i), RunJoiner::alone(number, row[i] >= 0.0)};
                                 ++number;
                             });
            }
        });
}

void RegionRuns::join_runs(const HeightField& field, std::size_t threads)
{
    for_each_slab(static_cast<std::size_t>(size_[2]), threads,
                  [&](std::size_t begin, std::size_t end)
                  {
                      Neighbourhood neighbourhood(*this, runs_);
                      SliceWindow slices(field, static_cast<int>(begin));
                      for (std::size_t k = begin; k < end; ++k)
                      {
                          if (k > begin)
                              slices.move_up();
                          neighbourhood.join_within_slice(slices.k());
                          if (slices.k() + 1 < size_[2])
                              neighbourhood.join_across_layer(slices);
                      }
                  });
}

// A set is named by its first run, so that in one pass the parent of every run has its number already.
void RegionRuns::number_regions()
{
    Region inside_count = 0;
    Region outside_count = 0;
    for (std::size_t run = 0; run < runs_.size(); ++run)
    {
        Region& region = runs_[run].region;
        const auto parent = static_cast<std::size_t>(RunJoiner::parent(region));
        if (parent != run)
            region = runs_[parent].region;
        else
            region = is_inside(region) ? ++inside_count : -++outside_count;
    }
}

Region RegionRuns::region(int i, int j, int k) const
{
    if (i < 0 || j < 0 || k < 0 || i >= size_[0] || j >= size_[1] || k >= size_[2])
        return kOuterRegion;
    const std::span<const Run> runs = row(j, k);
    const auto next = std::upper_bound(runs.begin(), runs.end(), i,
                                       [](int column, const Run& run) { return column < run.first; });
    return (next - 1)->region;
}

} // namespace voroprobe
