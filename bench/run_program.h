#pragma once

#include <exception>
#include <iostream>
#include <string>

#include "support/error.h"

namespace voroprobe::bench
{

//! The end of a main(): `program()`, which returns the exit status; of an exception, its message behind
//! `name`, and the status that goes with it, or 1.
template <typename Program>
int run_program(const std::string& name, const Program& program)
{
    try
    {
        return program();
    }
    catch (const Error& error)
    {
        std::cerr << name << ": " << error.what() << '\n';
        return static_cast<int>(error.status());
    }
    catch (const std::exception& error)
    {
        std::cerr << name << ": " << error.what() << '\n';
        return 1;
    }
}

} // namespace voroprobe::bench
