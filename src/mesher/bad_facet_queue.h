#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
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
    //! A facet as it was when pushed.
    struct Entry
    {
        FacetId id;
        std::uint32_t generation;
    };

    void push(FacetId id, std::uint32_t generation, Badness badness)
    {
        stacks_[static_cast<std::size_t>(badness)].push_back({id, generation});
    }

    //! The next facet that is still as it was when pushed, and how bad it is; counts the stale ones met.
    std::optional<std::pair<Entry, Badness>> pop(const RestrictedDelaunay& restricted,
                                                 std::size_t& stale_count)
    {
        for (std::size_t badness = 0; badness < kBadnessCount; ++badness)
        {
            auto& stack = stacks_[badness];
            while (!stack.empty())
            {
                const Entry entry = stack.back();
                stack.pop_back();
                if (restricted.facet(entry.id).generation == entry.generation)
                    return std::pair(entry, static_cast<Badness>(badness));
                ++stale_count;
            }
        }
        return std::nullopt;
    }

    //! Calls `look_at(entry, badness)` for all entries, stale ones included, the oldest of each badness
    //! first.
    template <typename LookAt>
    void visit(const LookAt& look_at) const
    {
        for (std::size_t badness = 0; badness < kBadnessCount; ++badness)
        {
            for (const Entry& entry : stacks_[badness])
                look_at(entry, static_cast<Badness>(badness));
        }
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
    std::array<std::vector<Entry>, kBadnessCount> stacks_;
};

} // namespace voroprobe
