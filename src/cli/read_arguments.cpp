#include "cli/read_arguments.h"

#include <CLI/CLI.hpp>

#include "cli/option_values.h"

namespace voroprobe
{

void add_read_options(CLI::App& command, ReadOptions& options)
{
    const char* const group = "Reading";
    command
        .add_option_function<std::string>(
            "--spacing",
            [&options](const std::string& text) { options.spacing = parse_spacing("--spacing", text); },
            "Distance of samples along the file's axes, mm (default: the file's; 1 where it has none)")
        ->type_name("X,Y,Z")
        ->group(group);
    command
        .add_option_function<std::string>(
            "--frame",
            [&options](const std::string& text) { options.frame = parse_count("--frame", text, 0); },
            "Which volume of a 4D file, from 0")
        ->type_name("N")
        ->group(group);
    command
        .add_option_function<std::string>(
            "--series", [&options](const std::string& text) { options.series = text; },
            "Which series of a DICOM folder: its instance UID or a unique part of it")
        ->type_name("UID")
        ->group(group);
    command
        .add_option_function<std::string>(
            "--grid", [&options](const std::string& text) { options.grid = text; },
            "Which grid of a .vdb file (default: the only float grid)")
        ->type_name("NAME")
        ->group(group);
}

} // namespace voroprobe
