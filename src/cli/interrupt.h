#pragma once

#include <cstddef>
#include <string_view>

namespace voroprobe
{

//! What clears the line of a terminal and goes back to its start.
constexpr std::string_view kWipeLine = "\r\x1b[K";

//! Catches SIGINT (Ctrl-C) and SIGTERM for the rest of the program, and makes writes beyond a limit on file
//! sizes fail rather than kill; to be called once, from main. A signal ends the program at once with status
//! 130, and the unfinished file that is being written, if any, is removed.
void install_interrupt_handlers();

//! Whether an unfinished line is on stderr, to be wiped before the message of a signal.
void set_bar_shown(bool shown);

//! True once a signal came that did not end the program.
bool interrupt_requested();

//! From here on a signal is only taken note of, as a file is about to take its place; a second one still ends
//! the program. To be called last before that. \throw Error (kInterrupted) where one came before.
void pass_point_of_no_return();

//! Says that a command writes so many files one by one: a signal then tells how many of them are there.
void expect_files(std::size_t count);

//! One of these is in its place. Until the next is about to, a signal ends the program again, and so does one
//! that came meanwhile; after the last the run is as good as over.
void note_file_written();

} // namespace voroprobe
