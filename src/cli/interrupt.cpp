#include "cli/interrupt.h"

#include <atomic>
#include <csignal>
#include <string_view>

#include <sys/time.h>
#include <unistd.h>

#include "support/error.h"

namespace voroprobe
{

namespace
{

//! With what leaving takes, still within a second.
constexpr itimerval kGrace{.it_interval = {0, 0}, .it_value = {.tv_sec = 0, .tv_usec = 800'000}};

std::atomic<OnInterrupt> on_interrupt = OnInterrupt::kExitAtOnce;
std::atomic<bool> requested = false;
std::atomic<bool> bar_shown = false;
static_assert(std::atomic<OnInterrupt>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "a signal handler may touch only lock-free atomics");

// The handlers do only what is safe in one: write(), _exit(), lock-free atomics and setitimer(), which is a
// plain system call like the alarm() that POSIX names, but not of whole seconds.

void write_error(std::string_view text)
{
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

void leave(int /*signal*/)
{
    if (bar_shown)
        write_error(kWipeLine);
    write_error("voroprobe: error: interrupted\n");
    _exit(static_cast<int>(ExitStatus::kInterrupted));
}

void handle_interrupt(int signal)
{
    if (on_interrupt == OnInterrupt::kExitAtOnce || requested.exchange(true))
        leave(signal);
    if (on_interrupt == OnInterrupt::kStopSoon)
        setitimer(ITIMER_REAL, &kGrace, nullptr);
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
    handle(SIGALRM, leave);
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
