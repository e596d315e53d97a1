#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

namespace voroprobe
{

//! An X display that VTK can draw on: the one there is (DISPLAY), or an Xvfb that is started and ended with
//! this object and at the latest with this process. Sets DISPLAY for what is started next.
class VirtualDisplay
{
public:
    VirtualDisplay();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    //! Why there is none, in one line; nullopt where there is one.
    [[nodiscard]] const std::optional<std::string>& failure() const { return failure_; }

private:
    std::optional<pid_t> server_;
    std::optional<std::string> failure_;
};

} // namespace voroprobe
