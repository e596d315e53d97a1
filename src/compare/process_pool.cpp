#include "compare/process_pool.h"

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <exception>
#include <iostream>
#include <utility>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{

namespace
{

//! How often children that are allowed a limited time are looked at.
constexpr int kMillisecondsBetweenLooks = 100;

[[noreturn]] void fail(const std::string& what)
{
    throw Error(ExitStatus::kInternal, "cannot start a process: " + what + ": " + std::strerror(errno));
}

std::FILE* nameless_file()
{
    std::FILE* file = std::tmpfile();
    if (file == nullptr)
        fail("a temporary file");
    return file;
}

std::string whole_text(std::FILE* file)
{
    std::rewind(file);
    std::string text;
    char buffer[1U << 16U];
    for (std::size_t read = 0; (read = std::fread(buffer, 1, sizeof buffer, file)) > 0;)
        text.append(buffer, read);
    return text;
}

//! Those that were sent whole.
std::vector<std::string> whole_parts(std::FILE* file)
{
    const std::string bytes = whole_text(file);
    std::vector<std::string> parts;
    std::uint64_t length = 0;
    for (std::size_t at = 0; at + sizeof length <= bytes.size(); at += length)
    {
        std::memcpy(&length, bytes.data() + at, sizeof length);
        at += sizeof length;
        if (length > bytes.size() - at)
            break;
        parts.push_back(bytes.substr(at, length));
    }
    return parts;
}

double seconds_of(const timeval& time)
{
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

std::string last_line(std::string text)
{
    const auto end = text.find_last_not_of(" \t\r\n");
    if (end == std::string::npos)
        return {};
    text.resize(end + 1);
    const auto start = text.find_last_of('\n');
    return start == std::string::npos ? text : text.substr(start + 1);
}

//! Runs in the child and never returns: the parent's destructors are not the child's to run.
[[noreturn]] void live_as_child(const ProcessPool::Work& work, std::FILE* output, std::FILE* messages)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    dup2(fileno(messages), STDOUT_FILENO);
    dup2(fileno(messages), STDERR_FILENO);
    int status = 1;
    try
    {
        ChildOutput child_output(output);
        work(child_output);
        status = 0;
    }
    catch (const std::bad_alloc&)
    {
        std::cerr << "\nout of memory" << std::endl;
    }
    catch (const std::exception& error)
    {
        std::string line = error.what();
        for (char& c : line)
            c = c == '\n' ? ' ' : c;
        std::cerr << '\n' << line << std::endl;
    }
    std::fflush(output);
    _exit(status);
}

std::string describe_end(int wait_status, const std::string& messages)
{
    const std::string line = last_line(messages);
    if (WIFSIGNALED(wait_status))
        return std::string("ended by signal ") + strsignal(WTERMSIG(wait_status)) +
               (line.empty() ? "" : " (" + line + ")");
    return line.empty() ? "exit status " + std::to_string(WEXITSTATUS(wait_status)) : line;
}

} // namespace

void ChildOutput::send(std::string_view part)
{
    const std::uint64_t length = part.size();
    if (std::fwrite(&length, sizeof length, 1, file_) != 1 ||
        std::fwrite(part.data(), 1, part.size(), file_) != part.size() || std::fflush(file_) != 0)
        throw OutputError(std::string("a temporary file cannot be written: ") + std::strerror(errno));
}

void ProcessPool::add(Work work, Done done, std::optional<double> max_seconds, Turn turn)
{
    Waiting waiting{std::move(work), std::move(done), max_seconds};
    if (turn == Turn::kNext)
        waiting_.push_front(std::move(waiting));
    else
        waiting_.push_back(std::move(waiting));
}

void ProcessPool::run()
{
    while (!waiting_.empty() || !running_.empty())
    {
        while (running_.size() < at_once_ && !waiting_.empty())
        {
            Waiting next = std::move(waiting_.front());
            waiting_.pop_front();
            start(std::move(next));
        }
        std::vector<pollfd> ends;
        for (const Running& child : running_)
            ends.push_back({.fd = child.end_of_life, .events = POLLIN, .revents = 0});
        poll(ends.data(), ends.size(), kMillisecondsBetweenLooks);
        end_late_ones();
        collect_ended();
    }
}

void ProcessPool::start(Waiting waiting)
{
    File output(nameless_file());
    File messages(nameless_file());
    int ends[2];
    if (pipe(ends) != 0)
        fail("pipe");
    std::cout.flush();
    std::fflush(nullptr);
    const pid_t process = fork();
    if (process < 0)
        fail("fork");
    if (process == 0)
    {
        close(ends[0]);
        live_as_child(waiting.work, output.get(), messages.get());
    }
    close(ends[1]);
    running_.push_back({process, ends[0], std::move(output), std::move(messages), std::move(waiting.done),
                        waiting.max_seconds, Clock::now()});
}

void ProcessPool::end_late_ones()
{
    for (Running& child : running_)
    {
        const double seconds = std::chrono::duration<double>(Clock::now() - child.start).count();
        if (child.timed_out || !child.max_seconds || seconds <= *child.max_seconds)
            continue;
        child.timed_out = true;
        kill(child.process, SIGKILL);
    }
}

void ProcessPool::collect_ended()
{
    for (std::size_t i = 0; i < running_.size();)
    {
        pollfd end{.fd = running_[i].end_of_life, .events = POLLIN, .revents = 0};
        if (poll(&end, 1, 0) == 0)
        {
            ++i;
            continue;
        }
        Running child = std::move(running_[i]);
        running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
        const ChildResult result = result_of(child);
        child.done(result); // may add more
    }
}

ChildResult ProcessPool::result_of(Running& child)
{
    close(child.end_of_life);
    int wait_status = 0;
    rusage usage{};
    while (wait4(child.process, &wait_status, 0, &usage) < 0 && errno == EINTR)
    {
    }
    ChildResult result{.parts = whole_parts(child.output.get()),
                       .failure = std::nullopt,
                       .cpu_seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime)};
    if (child.timed_out)
        result.failure = "not done after " + number_text(*child.max_seconds) + " s";
    else if (wait_status != 0)
        result.failure = describe_end(wait_status, whole_text(child.messages.get()));
    return result;
}

ChildResult run_in_child(const ProcessPool::Work& work, std::optional<double> max_seconds)
{
    ChildResult result;
    ProcessPool pool(1);
    pool.add(
        work, [&result](const ChildResult& ended) { result = ended; }, max_seconds);
    pool.run();
    return result;
}

} // namespace voroprobe
