#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "mesher/criteria.h"

namespace voroprobe
{

//! Bad facets by badness, the newest first within each: what was touched last is warm in the cache. That
//! costs some vertices against a global priority queue and is quicker. Entries of facets that have changed
//! since are dropped when met.
class BadFacetQueue
{
public:
    void push(FacetId id, std::uint32_t generation, Badness badness)
    {
        stacks_[static_cast<std::size_t>(badness)].push_back({id, generation});
    }

    //! The next facet that is still as it was when pushed; counts the stale ones met.
    std::optional<FacetId> pop(const RestrictedDelaunay& restricted, std::size_t& stale_count)
    {
        for (auto& stack : stacks_)
        {
            while (!stack.empty())
            {
                const Entry entry = stack.back();
                stack.pop_back();
                if (restricted.facet(entry.id).generation == entry.generation)
                    return entry.id;
                ++stale_count;
            }
        }
        return std::nullopt;
    }

    //! Entries, stale ones included.
    [[nodiscard]] std::size_t size() const
    {
        std::size_t total = 0;
        for (const auto& stack : stacks_)
            total += stack.size();
        return total;
    }

private:
    struct Entry
    {
        FacetId id;
        std::uint32_t generation;
    };
    std::array<std::vector<Entry>, kBadnessCount> stacks_;
};

} // namespace voroprobe
