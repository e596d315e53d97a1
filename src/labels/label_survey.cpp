#include "labels/label_survey.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>

#include "support/error.h"
#include "support/number_text.h"
#include "support/union_find.h"

namespace voroprobe
{
namespace
{

//! From here on a double leaves out whole numbers, and labels could be taken for one another.
constexpr double kFirstDoubtfulLabel = 9007199254740992.0; // 2^53

[[noreturn]] void refuse_sample(const GridGeometry& geometry, std::size_t offset, double value,
                                const std::string& allowed)
{
    const auto [columns, rows, slices] = geometry.size;
    const std::size_t row = offset / columns;
    const std::size_t slice = row / rows;
    const Point3 p_grid{geometry.spacing.x * static_cast<double>(offset % columns),
                        geometry.spacing.y * static_cast<double>(row % rows),
                        geometry.spacing.z * static_cast<double>(slice)};
    const Point3 index = geometry.source_index_from_grid * p_grid;
    const auto rounded = [](double x) { return std::to_string(std::lround(x)); };
    throw InputError("not a label map: the sample at index " + rounded(index.x) + ", " + rounded(index.y) +
                     ", " + rounded(index.z) + " of the file is " + number_text(value) +
                     "; allowed: " + allowed);
}

template <class Sample>
LabelValue label_of(const GridGeometry& geometry, std::size_t offset, Sample sample)
{
    if constexpr (std::is_floating_point_v<Sample>)
    {
        const auto value = static_cast<double>(sample);
        if (!(std::abs(value) < kFirstDoubtfulLabel))
            refuse_sample(geometry, offset, value, "whole numbers between -2^53 and 2^53");
        if (value != std::floor(value))
            refuse_sample(geometry, offset, value,
                          "whole numbers (for measurements give --isovalue, not --labels)");
    }
    return static_cast<LabelValue>(sample);
}

//! Calls run(j, k, first, end, label) for every row of equal samples that are not background, in the order of
//! memory, and next_row() before each row.
template <class Sample, class NextRow, class Visit>
void for_each_run(const GridGeometry& geometry, const std::vector<Sample>& samples, NextRow next_row,
                  Visit visit)
{
    const std::size_t columns = geometry.size[0];
    for (std::size_t row = 0; row < samples.size(); row += columns)
    {
        next_row();
        for (std::size_t first = 0, end = 0; first < columns; first = end)
        {
            const Sample sample = samples[row + first];
            for (end = first + 1; end < columns && samples[row + end] == sample;)
                ++end;
            if (sample == Sample{0})
                continue;
            visit(first, end, label_of(geometry, row + first, sample));
        }
    }
}

//! Whether two runs of neighbouring rows have voxels that share a face, an edge or a corner.
bool touch(const LabelRun& a, const LabelRun& b)
{
    return a.first <= b.end && b.first <= a.end;
}

//! Calls visit(i, j) for each run i of one row and j of a neighbouring one that touch. Places in `runs`.
template <class Visit>
void for_each_contact(const std::vector<LabelRun>& runs, std::size_t a, std::size_t a_end, std::size_t b,
                      std::size_t b_end, Visit visit)
{
    while (a < a_end && b < b_end)
    {
        if (touch(runs[a], runs[b]))
            visit(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
        // Of two that end together the first may touch the one after the second; all others come up.
        const std::int32_t end_a = runs[a].end;
        const std::int32_t end_b = runs[b].end;
        if (end_a == end_b && b + 1 < b_end && touch(runs[a], runs[b + 1]))
            visit(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b + 1));
        if (end_a <= end_b)
            ++a;
        else
            ++b;
    }
}

} // namespace

LabelSurvey::LabelSurvey(const Volume& volume)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        size_[axis] = static_cast<int>(volume.geometry.size[axis]);
    std::vector<LabelValue> value_of_run;
    std::visit(
        [&](const auto& samples)
        {
            for_each_run(
                volume.geometry, samples, [&] { row_begin_.push_back(runs_.size()); },
                [&](std::size_t first, std::size_t end, LabelValue label)
                {
                    runs_.push_back({static_cast<std::int32_t>(first), static_cast<std::int32_t>(end), 0});
                    value_of_run.push_back(label);
                });
        },
        volume.samples);
    row_begin_.push_back(runs_.size());
    if (runs_.size() > std::numeric_limits<std::uint32_t>::max())
        throw InputError("not a label map: " + std::to_string(runs_.size()) +
                         " runs of equal samples, expected fewer than 2^32");
    list_parts(value_of_run);
}

std::span<const LabelRun> LabelSurvey::row(int j, int k) const
{
    if (j < 0 || j >= size_[1] || k < 0 || k >= size_[2])
        return {};
    const std::size_t at =
        static_cast<std::size_t>(j) + static_cast<std::size_t>(k) * static_cast<std::size_t>(size_[1]);
    return {runs_.data() + row_begin_[at], row_begin_[at + 1] - row_begin_[at]};
}

std::size_t LabelSurvey::memory_bytes() const
{
    return runs_.size() * sizeof(LabelRun) + row_begin_.size() * sizeof(std::size_t) +
           parts_.size() * (sizeof(LabelPart) + sizeof(std::uint32_t)) +
           labels_.size() * sizeof(SurveyedLabel);
}

void LabelSurvey::join_touching(UnionFind& sets, const std::vector<LabelValue>& value_of_run) const
{
    const auto join_rows = [&](std::size_t a, std::size_t b)
    {
        for_each_contact(runs_, row_begin_[a], row_begin_[a + 1], row_begin_[b], row_begin_[b + 1],
                         [&](std::uint32_t i, std::uint32_t j)
                         {
                             if (value_of_run[i] == value_of_run[j])
                                 sets.unite(i, j);
                         });
    };
    const auto rows = static_cast<std::size_t>(size_[1]);
    for (std::size_t row = 0; row + 1 < row_begin_.size(); ++row)
    {
        const std::size_t j = row % rows;
        if (j > 0)
            join_rows(row, row - 1);
        if (row < rows)
            continue;
        const std::size_t below = row - rows;
        join_rows(row, below);
        if (j > 0)
            join_rows(row, below - 1);
        if (j + 1 < rows)
            join_rows(row, below + 1);
    }
}

void LabelSurvey::list_parts(const std::vector<LabelValue>& value_of_run)
{
    UnionFind sets(runs_.size());
    join_touching(sets, value_of_run);
    std::vector<LabelValue> value_of_part;
    for (std::size_t row = 0; row + 1 < row_begin_.size(); ++row)
    {
        const int j = static_cast<int>(row) % size_[1];
        const int k = static_cast<int>(row) / size_[1];
        for (std::size_t i = row_begin_[row]; i < row_begin_[row + 1]; ++i)
        {
            LabelRun& run = runs_[i];
            const std::uint32_t root = sets.find(static_cast<std::uint32_t>(i));
            run.part = root == i ? static_cast<std::uint32_t>(parts_.size()) : runs_[root].part;
            if (root == i)
            {
                parts_.push_back({.label = 0, .voxels = 0, .box = {}, .first_voxel = {run.first, j, k}});
                value_of_part.push_back(value_of_run[i]);
            }
            LabelPart& part = parts_[run.part];
            part.voxels += static_cast<std::size_t>(run.end - run.first);
            part.box.include(SampleIndex{run.first, j, k});
            part.box.include(SampleIndex{run.end - 1, j, k});
        }
    }
    list_labels(value_of_part);
}

void LabelSurvey::list_labels(const std::vector<LabelValue>& value_of_part)
{
    std::vector<std::uint32_t> by_value(parts_.size());
    std::iota(by_value.begin(), by_value.end(), 0U);
    std::stable_sort(by_value.begin(), by_value.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return value_of_part[a] < value_of_part[b]; });
    for (const std::uint32_t p : by_value)
    {
        if (labels_.empty() || labels_.back().value != value_of_part[p])
            labels_.push_back({.value = value_of_part[p], .voxels = 0, .box = {}, .parts = {}});
        SurveyedLabel& label = labels_.back();
        parts_[p].label = static_cast<std::uint32_t>(labels_.size() - 1);
        label.voxels += parts_[p].voxels;
        label.box.include(parts_[p].box);
        label.parts.push_back(p);
    }
}

} // namespace voroprobe
