#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace voroprobe
{

//! Where a child process puts what it found, part by part. What was sent whole arrives, however the child
//! ends.
class ChildOutput
{
public:
    explicit ChildOutput(std::FILE* file) : file_(file) {}

    //! \throw OutputError where the disk is full.
    void send(std::string_view part);

private:
    std::FILE* file_;
};

//! What came of a child process.
struct ChildResult
{
    std::vector<std::string> parts;
    std::optional<std::string>
        failure;              //!< why it did not end well: its last line on stderr, or the signal; one line
    double cpu_seconds = 0.0; //!< processor time of all its threads, user and system
};

//! Runs functions in child processes of their own, so that memory and crashes are theirs and slow ones can be
//! ended. They are forks: they see all that was there when they were started, and send back bytes. What they
//! print is kept from the terminal. They end when this process does. Linux.
//!
//! \pre no other thread of this process computes while run() works: a fork takes one thread along, and
//! whatever the others hold stays held. Idle ones, as logging libraries keep, do no harm.
class ProcessPool
{
public:
    using Work = std::function<void(ChildOutput&)>;
    using Done = std::function<void(const ChildResult&)>;

    //! \pre at_once > 0.
    explicit ProcessPool(std::size_t at_once) : at_once_(at_once) {}

    //! When work is begun that others wait with.
    enum class Turn
    {
        kLast,
        kNext
    };

    //! `done` is called in this process once the child has ended; it may add more. `max_seconds`: wall clock.
    void add(Work work, Done done, std::optional<double> max_seconds = std::nullopt, Turn turn = Turn::kLast);

    //! Until all have ended. \throw Error where a process cannot be started.
    void run();

private:
    using Clock = std::chrono::steady_clock;
    struct FileCloser
    {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    using File = std::unique_ptr<std::FILE, FileCloser>; //!< without a name: nothing is left behind

    struct Waiting
    {
        Work work;
        Done done;
        std::optional<double> max_seconds;
    };
    struct Running
    {
        pid_t process;
        int end_of_life; //!< a pipe's end, closed on the other side when the process ends
        File output;
        File messages;
        Done done;
        std::optional<double> max_seconds;
        Clock::time_point start;
        bool timed_out = false;
    };

    void start(Waiting waiting);
    void end_late_ones();
    void collect_ended();
    [[nodiscard]] static ChildResult result_of(Running& child);

    std::size_t at_once_;
    std::deque<Waiting> waiting_;
    std::vector<Running> running_;
};

//! One function, in a process of its own. \pre as above.
ChildResult run_in_child(const ProcessPool::Work& work, std::optional<double> max_seconds = std::nullopt);

} // namespace voroprobe
