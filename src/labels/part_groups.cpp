#include "labels/part_groups.h"

#include <algorithm>

#include "support/union_find.h"

namespace voroprobe
{
namespace
{

//! A part's surface lies within this many samples of its box.
constexpr int kReachOfSurface = 1;

//! Joins parts whose boxes meet: a sweep along x.
void join_boxes_that_meet(const std::vector<IndexBox>& boxes, UnionFind& sets)
{
    std::vector<std::uint32_t> by_first(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        by_first[i] = i;
    std::stable_sort(by_first.begin(), by_first.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return boxes[a].first[0] < boxes[b].first[0]; });
    std::vector<std::uint32_t> open; // boxes that the sweep is in
    for (const std::uint32_t box : by_first)
    {
        std::erase_if(open, [&](std::uint32_t other) { return boxes[other].last[0] < boxes[box].first[0]; });
        for (const std::uint32_t other : open)
            if (boxes[other].meets(boxes[box]))
                sets.unite(other, box);
        open.push_back(box);
    }
}

} // namespace

std::vector<PartGroup> group_parts(const LabelSurvey& survey, const SurveyedLabel& label)
{
    std::vector<IndexBox> boxes;
    boxes.reserve(label.parts.size());
    for (const std::uint32_t part : label.parts)
        boxes.push_back(survey.parts()[part].box.grown(kReachOfSurface));
    UnionFind sets(boxes.size());
    join_boxes_that_meet(boxes, sets);

    std::vector<PartGroup> groups;
    std::vector<std::uint32_t> group_of_root(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
    {
        const std::uint32_t root = sets.find(i);
        if (root == i)
        {
            group_of_root[i] = static_cast<std::uint32_t>(groups.size());
            groups.emplace_back();
        }
        PartGroup& group = groups[group_of_root[root]];
        group.parts.push_back(label.parts[i]);
        group.box.include(survey.parts()[label.parts[i]].box);
    }
    return groups;
}

PartMask cut_mask(const LabelSurvey& survey, const PartGroup& group)
{
    const IndexBox box = group.box.grown(kMaskMargin);
    PartMask mask{.first = box.first, .size = box.size(), .part = {}, .part_count = group.parts.size()};
    mask.part.resize(box.sample_count(), 0);
    const auto place_of = [&](std::uint32_t part) -> std::uint32_t
    {
        const auto found = std::lower_bound(group.parts.begin(), group.parts.end(), part);
        const bool ours = found != group.parts.end() && *found == part;
        return ours ? static_cast<std::uint32_t>(1 + (found - group.parts.begin())) : 0;
    };
    std::size_t row_begin = 0;
    for (int k = box.first[2]; k <= box.last[2]; ++k)
        for (int j = box.first[1]; j <= box.last[1]; ++j, row_begin += mask.size[0])
        {
            const auto runs = survey.row(j, k);
            auto run = std::partition_point(runs.begin(), runs.end(),
                                            [&](const LabelRun& r) { return r.end <= box.first[0]; });
            for (; run != runs.end() && run->first <= box.last[0]; ++run)
                if (const std::uint32_t place = place_of(run->part);
                    place != 0) // then all of it is in the box
                    std::fill_n(mask.part.begin() + static_cast<std::ptrdiff_t>(row_begin) +
                                    (run->first - box.first[0]),
                                run->end - run->first, place);
        }
    return mask;
}

} // namespace voroprobe
