#include "cli/info_command.h"

#include <iostream>

#include <CLI/CLI.hpp>

#include "cli/read_arguments.h"
#include "cli/surface_input.h"
#include "cli/vdb_info.h"
#include "cli/volume_info.h"
#include "cli/warnings.h"

namespace voroprobe
{

void add_info_arguments(CLI::App& command, InfoArguments& arguments)
{
    command
        .add_option("INPUT", arguments.input,
                    "Volume: a file, or a folder with a DICOM series or TIFF slices")
        ->required()
        ->type_name("");
    command.add_flag("--json", arguments.json, "One JSON object on stdout instead of text")->group("Output");
    add_read_options(command, arguments.read);
}

void run_info_command(const InfoArguments& arguments)
{
    check_read_options(arguments.input, arguments.read);
    if (is_vdb_path(arguments.input))
    {
        const VdbSurface surface = read_vdb_surface(arguments.input, {.grid = arguments.read.grid});
        print_warnings(surface.warnings);
        std::cout << (arguments.json ? vdb_info_json(arguments.input, surface)
                                     : vdb_info_text(arguments.input, surface));
        return;
    }
    const VolumeInfo info = volume_info(arguments.input, arguments.read);
    print_warnings(info.warnings);
    std::cout << (arguments.json ? volume_info_json(info) : volume_info_text(info));
}

} // namespace voroprobe
