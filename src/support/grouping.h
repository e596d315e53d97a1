#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace voroprobe
{

//! Items in groups 0 to group_count - 1, each group in the order in which its items were given: a counting
//! sort. Memory: 4 bytes a group beside the items.
template <class Item>
class Grouping
{
public:
    //! `for_each(visit)` calls visit(group, item) for every item, the same both times it is called.
    template <class ForEach>
    Grouping(std::size_t group_count, ForEach for_each) : begin_(group_count + 1, 0)
    {
        for_each([&](std::uint32_t group, const Item&) { ++begin_[group + 1]; });
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        items_.resize(begin_.back());
        std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
        for_each([&](std::uint32_t group, const Item& item) { items_[next[group]++] = item; });
    }

    //! Empty for groups beyond the last.
    [[nodiscard]] std::span<const Item> of(std::size_t group) const
    {
        if (group + 1 >= begin_.size())
            return {};
        return {items_.data() + begin_[group], items_.data() + begin_[group + 1]};
    }
    [[nodiscard]] std::span<Item> of(std::size_t group)
    {
        if (group + 1 >= begin_.size())
            return {};
        return {items_.data() + begin_[group], items_.data() + begin_[group + 1]};
    }

private:
    std::vector<std::uint32_t> begin_; //!< group g holds items begin_[g] to begin_[g + 1] - 1
    std::vector<Item> items_;
};

} // namespace voroprobe
