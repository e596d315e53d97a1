#pragma once

#include "cli/process_arguments.h"

namespace voroprobe
{

//! `voroprobe process`: reads a mesh made by anyone, works on it step by step, writes and reports. \throw
//! Error with the exit status; a step that would break a promise ends it before anything is written.
void run_process_command(const ProcessArguments& arguments);

} // namespace voroprobe
