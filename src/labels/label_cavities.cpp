#include "labels/label_cavities.h"

#include <algorithm>
#include <map>
#include <vector>

#include "support/union_find.h"

namespace voroprobe
{
namespace
{

//! A row of samples that are not the label's, from `first` to before `end`.
struct Gap
{
    std::int32_t first;
    std::int32_t end;
};

//! The gaps of a row within the box and one sample beyond it.
std::vector<Gap> gaps_in_row(const LabelSurvey& survey, const SurveyedLabel& label, std::uint32_t place,
                             const SampleIndex& row)
{
    std::vector<Gap> gaps;
    std::int32_t begin = label.box.first[0] - 1;
    for (const LabelRun& run : survey.row(row[1], row[2]))
        if (survey.parts()[run.part].label == place)
        {
            if (begin < run.first)
                gaps.push_back({begin, run.first});
            begin = run.end;
        }
    gaps.push_back({begin, label.box.last[0] + 2});
    return gaps;
}

//! Joins gaps of neighbouring rows that share a face of a voxel. Gaps are numbered from the first of each
//! row.
void join_rows(UnionFind& sets, const std::vector<Gap>& a, std::uint32_t first_a, const std::vector<Gap>& b,
               std::uint32_t first_b)
{
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();)
    {
        if (std::max(a[i].first, b[j].first) < std::min(a[i].end, b[j].end))
            sets.unite(first_a + static_cast<std::uint32_t>(i), first_b + static_cast<std::uint32_t>(j));
        ++(a[i].end < b[j].end ? i : j);
    }
}

} // namespace

std::vector<CavityRun> find_cavities(const LabelSurvey& survey, std::uint32_t place)
{
    const SurveyedLabel& label = survey.labels()[place];
    const int rows = label.box.last[1] - label.box.first[1] + 3; // one beyond on either side
    const int slices = label.box.last[2] - label.box.first[2] + 3;
    const auto j_of = [&](int row) { return label.box.first[1] - 1 + row; };
    const auto k_of = [&](int slice) { return label.box.first[2] - 1 + slice; };
    std::vector<std::vector<Gap>> gaps;
    std::vector<std::uint32_t> first{0};
    for (int k = 0; k < slices; ++k)
        for (int j = 0; j < rows; ++j)
        {
            gaps.push_back(gaps_in_row(survey, label, place, {0, j_of(j), k_of(k)}));
            first.push_back(first.back() + static_cast<std::uint32_t>(gaps.back().size()));
        }
    UnionFind sets(first.back());
    for (int k = 0; k < slices; ++k)
        for (int j = 0; j < rows; ++j)
        {
            const auto row =
                static_cast<std::size_t>(k) * static_cast<std::size_t>(rows) + static_cast<std::size_t>(j);
            const auto join = [&](std::size_t before)
            { join_rows(sets, gaps[before], first[before], gaps[row], first[row]); };
            if (j > 0)
                join(row - 1);
            if (k > 0)
                join(row - static_cast<std::size_t>(rows));
        }
    std::vector<CavityRun> runs;
    std::map<std::uint32_t, std::uint32_t> cavity_of_set;
    const std::uint32_t outside = sets.find(0); // goes round the box
    for (std::size_t row = 0; row < gaps.size(); ++row)
        for (std::uint32_t n = 0; n < gaps[row].size(); ++n)
            if (const std::uint32_t set = sets.find(first[row] + n); set != outside)
                runs.push_back({j_of(static_cast<int>(row) % rows), k_of(static_cast<int>(row) / rows),
                                gaps[row][n].first, gaps[row][n].end,
                                cavity_of_set.emplace(set, cavity_of_set.size()).first->second});
    return runs;
}

std::size_t count_cavities(const LabelSurvey& survey, std::uint32_t label)
{
    const std::vector<CavityRun> runs = find_cavities(survey, label);
    const auto last = std::max_element(
        runs.begin(), runs.end(), [](const CavityRun& a, const CavityRun& b) { return a.cavity < b.cavity; });
    return last == runs.end() ? 0 : std::size_t{last->cavity} + 1;
}

} // namespace voroprobe
