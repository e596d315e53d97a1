#pragma once

#include <filesystem>

#include "io/volume_reader.h"

namespace CLI // NOLINT(readability-identifier-naming): the name of the library
{
class App;
}

namespace voroprobe
{

//! Everything the user can say to `voroprobe info`.
struct InfoArguments
{
    std::filesystem::path input;
    ReadOptions read;
    bool json = false; //!< an object on stdout instead of text
};

//! Declares the command's options; `arguments` must outlive the parsing and holds the values after it.
void add_info_arguments(CLI::App& command, InfoArguments& arguments);

//! `voroprobe info`: tells on stdout what a file holds and which isovalues suit it. \throw as load_surface.
void run_info_command(const InfoArguments& arguments);

} // namespace voroprobe
