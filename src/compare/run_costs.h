#pragma once

#include <cstddef>

#include <nlohmann/json_fwd.hpp>

#include "compare/stage_clock.h"

namespace voroprobe
{

//! Time and memory of a contestant's run, from when this is made until end().
class RunCosts
{
public:
    //! Gives memory that was freed before back to the system: it must not be there to be used again unseen.
    RunCosts();

    [[nodiscard]] StageClock& clock() { return clock_; }

    //! "time" (stages and their sums) and "peak_memory_bytes" (beside what was there before), as report.json
    //! has them.
    [[nodiscard]] nlohmann::ordered_json end();

private:
    StageClock clock_;
    std::size_t peak_before_;
};

} // namespace voroprobe
