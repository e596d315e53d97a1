#pragma once

namespace voroprobe
{

//! What SIGINT (Ctrl-C) and SIGTERM do.
enum class OnInterrupt
{
    kExitAtOnce, //!< leave with status 130: while reading, when there is nothing to clean up
    kStopSoon    //!< set a flag that computations look at; a second signal leaves at once
};

//! Catches SIGINT and SIGTERM for the rest of the program; to be called once, from main.
void install_interrupt_handlers();

void set_on_interrupt(OnInterrupt what);

//! True once a signal came in mode kStopSoon.
bool interrupt_requested();

} // namespace voroprobe
