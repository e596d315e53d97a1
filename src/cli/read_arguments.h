#pragma once

#include "io/volume_reader.h"

namespace CLI // NOLINT(readability-identifier-naming): the name of the library
{
class App;
}

namespace voroprobe
{

//! Declares the options that say how to read a volume; both commands take them. `options` must outlive the
//! parsing.
void add_read_options(CLI::App& command, ReadOptions& options);

} // namespace voroprobe
