#pragma once

#include <string>
#include <vector>

namespace voroprobe
{

//! One step of a computation, seconds.
struct Stage
{
    std::string name;
    double wall_seconds = 0.0;
    double cpu_seconds = 0.0; //!< processor time of all threads of the process
};

//! Times the steps of a computation one after the other.
class StageClock
{
public:
    //! Ends the step before and begins another.
    void begin(std::string name);

    //! Ends the last step. All steps so far, in their order.
    const std::vector<Stage>& end();

private:
    void close();

    std::vector<Stage> stages_;
    bool running_ = false;
    double wall_start_ = 0.0;
    double cpu_start_ = 0.0;
};

} // namespace voroprobe
