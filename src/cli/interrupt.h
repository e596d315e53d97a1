#pragma once

#include <string_view>

namespace voroprobe
{

//! What clears the line of a terminal and goes back to its start.
constexpr std::string_view kWipeLine = "\r\x1b[K";

//! What a first SIGINT (Ctrl-C) or SIGTERM does; a second one always leaves at once, with status 130.
enum class OnInterrupt
{
    kExitAtOnce, //!< leave with status 130: while reading, when there is nothing to clean up
    kStopSoon, //!< ask computations to stop (interrupt_requested()); leave within a second where they do not
    kFinish    //!< take note: while writing, which is soon over and must not be cut in two
};

//! Catches SIGINT and SIGTERM for the rest of the program, and makes writes beyond a limit on file sizes fail
//! rather than kill; to be called once, from main.
void install_interrupt_handlers();

void set_on_interrupt(OnInterrupt what);

//! Whether an unfinished line is on stderr, to be wiped before the message of a signal.
void set_bar_shown(bool shown);

//! True once a signal came in another mode than kExitAtOnce.
bool interrupt_requested();

} // namespace voroprobe
