#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "bench/standings.h"

namespace voroprobe::bench
{

//! What is asked of us, and what was measured.
struct Target
{
    enum class Bound
    {
        kAtLeast,
        kAtMost
    };

    std::string what;
    double measured;
    Bound bound;
    double asked;

    [[nodiscard]] bool holds() const
    {
        return bound == Bound::kAtLeast ? measured >= asked : measured <= asked;
    }
};

//! Those whose contestants are all among the standings, and did not fail. One thread is held against one by
//! processor time, two threads by the clock on the wall.
std::vector<Target> evaluate_targets(const std::vector<Standing>& standings, std::size_t voxels);

//! What was measured, what is asked, and whether it holds.
void print_targets(std::ostream& out, const std::vector<Target>& targets);

nlohmann::json to_json(const std::vector<Target>& targets);

} // namespace voroprobe::bench
