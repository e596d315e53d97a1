#include "cli/interrupt.h"

#include <atomic>
#include <csignal>
#include <string_view>

#include <unistd.h>

#include "support/error.h"

namespace voroprobe
{

namespace
{

constexpr unsigned kGraceSeconds = 1;

std::atomic<OnInterrupt> on_interrupt = OnInterrupt::kExitAtOnce;
std::atomic<bool> requested = false;
static_assert(std::atomic<OnInterrupt>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "a signal handler may touch only lock-free atomics");

// The handlers do only what POSIX allows in one: write(), alarm(), _exit() and lock-free atomics.

void leave(int /*signal*/)
{
    constexpr std::string_view kMessage = "\nvoroprobe: error: interrupted\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, kMessage.data(), kMessage.size());
    _exit(static_cast<int>(ExitStatus::kInterrupted));
}

void handle_interrupt(int signal)
{
    if (on_interrupt == OnInterrupt::kExitAtOnce || requested.exchange(true))
        leave(signal);
    if (on_interrupt == OnInterrupt::kStopSoon)
        alarm(kGraceSeconds);
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

bool interrupt_requested()
{
    return requested;
}

} // namespace voroprobe
