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

std::atomic<bool> exit_at_once = true;
std::atomic<bool> requested = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch only lock-free atomics");

//! Only what POSIX allows in a handler: write(), _exit() and lock-free atomics.
void handle_signal(int /*signal*/)
{
    if (!exit_at_once.load() && !requested.exchange(true))
        return;
    constexpr std::string_view kMessage = "\nvoroprobe: error: interrupted\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, kMessage.data(), kMessage.size());
    _exit(static_cast<int>(ExitStatus::kInterrupted));
}

} // namespace

void install_interrupt_handlers()
{
    struct sigaction action = {};
    action.sa_handler = handle_signal;
    action.sa_flags = SA_RESTART; // a first signal must not break a read or write that is under way
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

void set_on_interrupt(OnInterrupt what)
{
    exit_at_once = what == OnInterrupt::kExitAtOnce;
}

bool interrupt_requested()
{
    return requested;
}

} // namespace voroprobe
