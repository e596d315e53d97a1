#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace voroprobe
{

//! Threads that do independent work side by side.
class Workers
{
public:
    //! `threads`: 0 for all there are; never more than that.
    explicit Workers(std::size_t threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    //! Calls `work(i)` for every i below `count`, in any order and several at once, about `at_once` in a row
    //! on one thread. Exceptions of `work` come out. Pays from some tens of microseconds of work on.
    void for_each(std::size_t count, const std::function<void(std::size_t i)>& work,
                  std::size_t at_once) const;

private:
    struct Arena;
    std::unique_ptr<Arena> arena_; //!< null where there is one thread: everything runs on the caller's
};

} // namespace voroprobe
