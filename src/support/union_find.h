#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace voroprobe
{

//! Disjoint sets of {0, ..., count - 1} with path halving; each is named by its smallest member.
class UnionFind
{
public:
    explicit UnionFind(std::size_t count)
    {
        parent_.reserve(count);
        for (std::uint32_t i = 0; i < count; ++i)
            parent_.push_back(i);
    }

    std::uint32_t find(std::uint32_t i)
    {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void unite(std::uint32_t i, std::uint32_t j)
    {
        i = find(i);
        j = find(j);
        parent_[std::max(i, j)] = std::min(i, j);
    }

private:
    std::vector<std::uint32_t> parent_;
};

} // namespace voroprobe
