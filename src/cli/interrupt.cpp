#include "cli/interrupt.h"

#include <atomic>
#include <csignal>
#include <string_view>

#include <unistd.h>

#include "io/atomic_file.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

std::atomic<OnInterrupt> on_interrupt = OnInterrupt::kLeaveAtOnce;
std::atomic<bool> requested = false;
std::atomic<bool> bar_shown = false;
static_assert(std::atomic<OnInterrupt>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "a signal handler may touch only lock-free atomics");

// The handler does only what is safe in one: write(), unlink(), _exit() and lock-free atomics.

void write_error(std::string_view text)
{
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

void leave()
{
    remove_unfinished_file();
    if (bar_shown)
        write_error(kWipeLine);
    write_error("voroprobe: error: interrupted\n");
    _exit(static_cast<int>(ExitStatus::kInterrupted));
}

void handle_interrupt(int /*signal*/)
{
    const bool again = requested.exchange(true); // before the mode is looked at, see interrupt_requested()
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

void set_on_interrupt(OnInterrupt what)
{
    on_interrupt = what;
}

void set_bar_shown(bool shown)
{
    bar_shown = shown;
}

bool interrupt_requested()
{
    return requested;
}

} // namespace voroprobe
