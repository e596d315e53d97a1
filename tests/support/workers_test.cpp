#include "support/workers.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "support/thread_limit.h"

namespace voroprobe
{
namespace
{

TEST(Workers, work_is_done_once_for_every_index)
{
    for (const std::size_t threads : {0U, 1U, 2U, 7U})
    {
        const Workers workers(threads);
        for (const std::size_t count : {0U, 1U, 5U, 1000U})
        {
            std::vector<std::atomic<int>> times(count);
            workers.for_each(
                count, [&](std::size_t i) { ++times[i]; }, 3);
            for (const std::atomic<int>& time : times)
                EXPECT_EQ(time, 1);
        }
    }
}

TEST(Workers, an_exception_comes_out)
{
    const auto fail_once = [](std::size_t i)
    {
        if (i == 57)
            throw std::runtime_error("57");
    };
    for (const std::size_t threads : {1U, 2U})
        EXPECT_THROW(Workers(threads).for_each(100, fail_once, 1), std::runtime_error);
}

TEST(Workers, go_on_under_a_limit_of_one_thread)
{
    const ThreadLimit limit(1);
    std::atomic<int> calls{0};
    Workers(2).for_each(
        64, [&](std::size_t) { ++calls; }, 1);
    EXPECT_EQ(calls, 64);
}

} // namespace
} // namespace voroprobe
