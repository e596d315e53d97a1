#pragma once

#include <string_view>

namespace voroprobe
{

//! What clears the line of a terminal and goes back to its start.
constexpr std::string_view kWipeLine = "\r\x1b[K";

//! What a first SIGINT (Ctrl-C) or SIGTERM does; a second one always leaves at once. Leaving is with status
//! 130, and the unfinished file that is being written, if any, is removed.
enum class OnInterrupt
{
    kLeaveAtOnce, //!< from the start on: there is nothing else to clean up
    kFinish       //!< take note: the output takes its place, and the run is as good as over
};

//! Catches SIGINT and SIGTERM for the rest of the program, and makes writes beyond a limit on file sizes fail
//! rather than kill; to be called once, from main.
void install_interrupt_handlers();

void set_on_interrupt(OnInterrupt what);

//! Whether an unfinished line is on stderr, to be wiped before the message of a signal.
void set_bar_shown(bool shown);

//! True once a signal came. To be asked after a change to kFinish: either the signal found the old mode and
//! this is true, or it finds the new one.
bool interrupt_requested();

} // namespace voroprobe
