#include "compare/process_pool.h"

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <stdexcept>

#include <gtest/gtest.h>
#include <unistd.h>

namespace voroprobe
{

namespace
{

TEST(ProcessPool, parts_come_back_whole_and_in_order)
{
    const std::string large(3'000'000, 'x');
    const ChildResult result = run_in_child(
        [&](ChildOutput& output)
        {
            output.send("first");
            output.send("");
            output.send(large);
        });
    EXPECT_FALSE(result.failure);
    ASSERT_EQ(result.parts.size(), 3U);
    EXPECT_EQ(result.parts[0], "first");
    EXPECT_EQ(result.parts[1], "");
    EXPECT_EQ(result.parts[2], large);
}

TEST(ProcessPool, a_child_tells_its_processor_time_and_not_how_long_it_waited)
{
    constexpr double kBusySeconds = 0.05;
    const ChildResult busy = run_in_child(
        [](ChildOutput&)
        {
            while (static_cast<double>(std::clock()) < kBusySeconds * CLOCKS_PER_SEC)
            {
            }
        });
    EXPECT_GE(busy.cpu_seconds, 0.9 * kBusySeconds); // the system counts in ticks
    const ChildResult idle = run_in_child([](ChildOutput&) { usleep(300'000); });
    EXPECT_LT(idle.cpu_seconds, 0.3);
}

TEST(ProcessPool, an_exception_is_told_in_one_line)
{
    const ChildResult result =
        run_in_child([](ChildOutput&) { throw std::runtime_error("no surface\nat all"); });
    EXPECT_EQ(result.failure, "no surface at all");
}

TEST(ProcessPool, what_was_sent_before_a_crash_is_kept)
{
    const ChildResult result = run_in_child(
        [](ChildOutput& output)
        {
            output.send("half");
            std::abort();
        });
    ASSERT_TRUE(result.failure);
    EXPECT_NE(result.failure->find("signal"), std::string::npos) << *result.failure;
    EXPECT_EQ(result.parts, std::vector<std::string>{"half"});
}

TEST(ProcessPool, a_child_that_takes_too_long_is_ended)
{
    const ChildResult result = run_in_child([](ChildOutput&) { pause(); }, 0.2);
    EXPECT_EQ(result.failure, "not done after 0.2 s");
}

TEST(ProcessPool, one_done_may_add_another)
{
    std::string order;
    ProcessPool pool(2);
    const auto send_a = [](ChildOutput& output) { output.send("a"); };
    pool.add(send_a,
             [&](const ChildResult& first)
             {
                 order += first.parts.front();
                 pool.add([](ChildOutput& output) { output.send("b"); },
                          [&](const ChildResult& second) { order += second.parts.front(); });
             });
    pool.run();
    EXPECT_EQ(order, "ab");
}

TEST(ProcessPool, no_more_run_at_once_than_allowed)
{
    // Each child sees the clock when it begins and when it ends; one at a time, no two overlap.
    std::vector<std::pair<double, double>> spans;
    ProcessPool pool(1);
    for (int i = 0; i < 3; ++i)
        pool.add(
            [](ChildOutput& output)
            {
                const auto now = []
                {
                    return std::to_string(
                        std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
                            .count());
                };
                const std::string begin = now();
                usleep(20'000);
                output.send(begin);
                output.send(now());
            },
            [&](const ChildResult& result)
            { spans.emplace_back(std::stod(result.parts[0]), std::stod(result.parts[1])); });
    pool.run();
    ASSERT_EQ(spans.size(), 3U);
    EXPECT_LE(spans[0].second, spans[1].first);
    EXPECT_LE(spans[1].second, spans[2].first);
}

} // namespace

} // namespace voroprobe
