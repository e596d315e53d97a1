#pragma once

#include "cli/check_arguments.h"

namespace voroprobe
{

//! `voroprobe check`: reads a mesh made by anyone, tells what it is, and holds it against a scan where one is
//! given. Returns where the mesh is closed, manifold, oriented and free of self-intersections, and complete
//! against the scan. \throw Error with kIncomplete and the reason otherwise, after the report; InputError
//! where a file cannot be read.
void run_check_command(const CheckArguments& arguments);

} // namespace voroprobe
