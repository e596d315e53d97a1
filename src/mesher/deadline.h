#pragma once

#include <limits>
#include <optional>

#include "support/progress.h"
#include "support/stopwatch.h"

namespace voroprobe
{

//! Passes reports on to another sink, which may be null, and asks to stop when that does or when time is up.
class Deadline final : public ProgressSink
{
public:
    Deadline(ProgressSink* sink, const std::optional<double>& max_seconds)
        : sink_(sink), max_seconds_(max_seconds.value_or(std::numeric_limits<double>::infinity()))
    {
    }

    void report(const ProgressReport& report) override
    {
        if (sink_ != nullptr)
            sink_->report(report);
    }

    [[nodiscard]] bool stop_requested() const override
    {
        return is_expired() || (sink_ != nullptr && sink_->stop_requested());
    }

    [[nodiscard]] bool is_expired() const { return stopwatch_.seconds() >= max_seconds_; }

private:
    ProgressSink* sink_;
    double max_seconds_;
    Stopwatch stopwatch_;
};

} // namespace voroprobe
