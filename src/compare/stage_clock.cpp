#include "compare/stage_clock.h"

#include <ctime>
#include <utility>

namespace voroprobe
{

namespace
{

double seconds_of(clockid_t clock)
{
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

void StageClock::begin(std::string name)
{
    close();
    stages_.push_back({.name = std::move(name)});
    running_ = true;
    wall_start_ = seconds_of(CLOCK_MONOTONIC);
    cpu_start_ = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
}

const std::vector<Stage>& StageClock::end()
{
    close();
    return stages_;
}

void StageClock::close()
{
    if (!running_)
        return;
    stages_.back().wall_seconds = seconds_of(CLOCK_MONOTONIC) - wall_start_;
    stages_.back().cpu_seconds = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - cpu_start_;
    running_ = false;
}

} // namespace voroprobe
