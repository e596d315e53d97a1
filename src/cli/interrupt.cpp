#include "cli/interrupt.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <csignal>
#include <string>

#include <unistd.h>

#include "io/atomic_file.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

//! What a first signal does.
enum class OnInterrupt
{
    kLeaveAtOnce, //!< from the start on: there is nothing else to clean up
    kFinish       //!< take note: the output takes its place
};

std::atomic<OnInterrupt> on_interrupt = OnInterrupt::kLeaveAtOnce;
std::atomic<bool> requested = false;
std::atomic<bool> bar_shown = false;
std::atomic<std::size_t> files_expected = 0; //!< 0: not told
std::atomic<std::size_t> files_written = 0;
static_assert(std::atomic<OnInterrupt>::is_always_lock_free && std::atomic<bool>::is_always_lock_free &&
                  std::atomic<std::size_t>::is_always_lock_free,
              "a signal handler may touch only lock-free atomics");

// The handler does only what is safe in one: write(), unlink(), _exit(), lock-free atomics, and no memory of
// the heap.

//! A line of bounded length.
class Line
{
public:
    Line& operator<<(std::string_view text)
    {
        const std::size_t fits = std::min(text.size(), characters_.size() - size_);
        std::copy_n(text.begin(), fits, characters_.begin() + size_);
        size_ += fits;
        return *this;
    }

    Line& operator<<(std::size_t number)
    {
        std::array<char, 20> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
        return *this << std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data()));
    }

    [[nodiscard]] std::string_view text() const { return {characters_.data(), size_}; }

private:
    std::array<char, 120> characters_{};
    std::size_t size_ = 0;
};

//! "; 3 of 20 files were written"
void tell_files(Line& line)
{
    if (files_written == 0)
        line << "; nothing was written";
    else
        line << "; " << files_written.load() << " of " << files_expected.load() << " files were written";
}

void write_error(std::string_view text)
{
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

void leave()
{
    remove_unfinished_file();
    if (bar_shown)
        write_error(kWipeLine);
    Line line;
    line << "voroprobe: error: interrupted";
    if (files_expected > 0)
        tell_files(line);
    line << "\n";
    write_error(line.text());
    _exit(static_cast<int>(ExitStatus::kInterrupted));
}

void handle_interrupt(int /*signal*/)
{
    const bool again =
        requested.exchange(true); // before the mode is looked at, see pass_point_of_no_return()
    if (again || on_interrupt == OnInterrupt::kLeaveAtOnce)
        leave();
}

void handle(int signal, void (*handler)(int))
{
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART; // a first signal must not break a read or write that is under way
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

} // namespace

void install_interrupt_handlers()
{
    handle(SIGINT, handle_interrupt);
    handle(SIGTERM, handle_interrupt);
    handle(SIGXFSZ, SIG_IGN); // a limit on the size of files is a write that fails, as on a full disk
}

void set_bar_shown(bool shown)
{
    bar_shown = shown;
}

bool interrupt_requested()
{
    return requested;
}

void pass_point_of_no_return()
{
    on_interrupt = OnInterrupt::kFinish;
    if (!requested) // either the signal found the old mode and this is true, or it finds the new one
        return;
    Line line;
    line << "interrupted";
    tell_files(line);
    throw Error(ExitStatus::kInterrupted, std::string(line.text()));
}

void expect_files(std::size_t count)
{
    files_expected = count;
}

void note_file_written()
{
    if (++files_written == files_expected)
        return;
    on_interrupt = OnInterrupt::kLeaveAtOnce;
    if (requested)
        leave();
}

} // namespace voroprobe
