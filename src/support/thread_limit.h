#pragma once

#include <cstddef>
#include <memory>

namespace voroprobe
{

//! While it lives, no more than so many threads of the process work side by side.
class ThreadLimit
{
public:
    //! `threads` > 0.
    explicit ThreadLimit(std::size_t threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

} // namespace voroprobe
