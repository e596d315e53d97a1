#pragma once

#include <memory>

namespace voroprobe
{

//! As long as it lives, what this process computes it computes on one thread: processes can then be forked
//! from it, and those keep to one thread, too.
class OneThread
{
public:
    OneThread();
    ~OneThread();
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

} // namespace voroprobe
