#pragma once

#include <string>

namespace CLI // NOLINT(readability-identifier-naming): the name of the library
{
class App;
}

namespace voroprobe
{

//! What to say of a command line with arguments that nobody expected: the first of them, and the option that
//! is spelt nearly so, or the commands there are. \pre `app` has parsed a command line with such arguments.
std::string unknown_argument_text(const CLI::App& app);

} // namespace voroprobe
