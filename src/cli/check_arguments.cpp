#include "cli/check_arguments.h"

#include <vector>

#include <CLI/CLI.hpp>

#include "cli/option_group.h"
#include "cli/option_values.h"
#include "cli/read_arguments.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

const NumberRule kAnyAngle{[](double x) { return x >= 0.0 && x <= 60.0; }, "a number from 0 to 60, degrees"};

//! Surfaces that are large enough to compare have more.
constexpr std::size_t kFewestSamples = 100;

CLI::Option* add_scan(OptionGroup& group, CheckArguments& arguments)
{
    return group.text("--against", "VOLUME",
                      "Scan to hold the mesh against: a file, or a folder with a\nDICOM series or TIFF "
                      "slices; the options below go with it only",
                      [&arguments](const std::string& given) { arguments.against = given; });
}

void add_surface_options(OptionGroup& group, CheckArguments& arguments)
{
    group.isovalue(arguments.isovalue,
                   "Value of the samples at the surface (default auto: Otsu's threshold)");
    group.inside(arguments.inside,
                 "Side of the isovalue the object lies on (default auto: below for\nlevel sets in .vdb "
                 "files, above otherwise)");
    group.choice(
        "--border", arguments.border,
        Words<BorderFaces>{{"closed", BorderFaces::kClosed}, {"open", BorderFaces::kOpen}},
        "Where the object leaves the volume: the mesh is closed there, or\nmay end (default closed)");
    group.choice("--frame-of-reference", arguments.frame,
                 Words<OutputFrame>{
                     {"lps", OutputFrame::kLps}, {"ras", OutputFrame::kRas}, {"index", OutputFrame::kIndex}},
                 "Coordinates of the mesh: lps or ras in mm, or voxels of the file\n(default lps)");
}

void add_comparison_options(OptionGroup& group, CheckArguments& arguments)
{
    group.number("--size", "MM", arguments.criteria.max_radius, kLength,
                 "Count faces whose ball has a larger radius, mm");
    group.number("--distance", "MM", arguments.criteria.max_center_distance, kLength,
                 "Count faces whose circumcenter is farther from the surface, mm");
    group.text("--samples", "N",
               "Points of the mesh to measure the distance at, and half as\nmany of the surface "
               "(default 20000)",
               [&arguments](const std::string& given)
               { arguments.samples = parse_count("--samples", given, kFewestSamples); });
}

const NumberRule kDensity{[](double x) { return x > 0.0; }, "a number > 0, g/cm3"};
const NumberRule kOverhang{[](double x) { return x > 0.0 && x < 90.0; },
                           "a number above 0 and below 90, degrees from the vertical"};

void add_print_options(CLI::App& command, CheckArguments& arguments)
{
    constexpr const char* kGroup = "Printing (z is up, lengths in mm)";
    OptionGroup group(command, kGroup);
    CLI::Option* const printable = command.add_flag(
        "--printable", arguments.printable,
        "Judge whether it can be printed: size, bodies, cavities, walls,\ngaps, overhangs, material");
    printable->group(kGroup);
    PrintOptions& print = arguments.print;
    group
        .text("--min-wall", "MM", "Fail where a wall is thinner, mm",
              [&print](const std::string& given)
              { print.min_wall = parse_number("--min-wall", given, kLength); })
        ->needs(printable);
    group
        .text("--bed", "X,Y,Z", "Fail where it does not fit this build volume, mm",
              [&print](const std::string& given) { print.bed = parse_spacing("--bed", given); })
        ->needs(printable);
    group
        .text("--density", "G", "Tell the weight at this density, g/cm3",
              [&print](const std::string& given)
              { print.density_g_cm3 = parse_number("--density", given, kDensity); })
        ->needs(printable);
    group
        .text("--overhang", "DEG",
              "Faces that lean out farther from the vertical hang over, degrees\n(default 45)",
              [&print](const std::string& given)
              { print.overhang_deg = parse_number("--overhang", given, kOverhang); })
        ->needs(printable);
}

//! \throw UsageError where an option is given that says something of a scan, and no scan is.
void refuse_without(const CLI::Option& against, const std::vector<CLI::Option*>& of_scan)
{
    for (const CLI::Option* option : of_scan)
        if (against.count() == 0 && option->count() > 0)
            throw UsageError(option->get_name() + " is '" + option->results().front() +
                             "'; allowed: only with --against VOLUME");
}

} // namespace

void add_check_arguments(CLI::App& command, CheckArguments& arguments)
{
    command.add_option("MESH", arguments.mesh, "Mesh to check: .stl .ply .obj .off .vtp .3mf")
        ->required()
        ->type_name("");
    OptionGroup mesh(command, "Mesh");
    mesh.number("--angle", "DEG", arguments.criteria.min_angle_deg, kAnyAngle,
                "Count faces with a smaller angle as well, degrees, 0 to 60");
    mesh.text("--json", "FILE", "Write what was found as JSON",
              [&arguments](const std::string& given) { arguments.json = given; });
    command.add_flag("-q,--quiet", arguments.quiet, "No report on stdout; warnings and errors stay")
        ->group("Mesh");

    add_print_options(command, arguments);
    OptionGroup scan(command, "Scan");
    CLI::Option* const against = add_scan(scan, arguments);
    const std::size_t before = command.get_options().size();
    add_surface_options(scan, arguments);
    add_comparison_options(scan, arguments);
    add_read_options(command, arguments.read);
    const auto options = command.get_options();
    command.parse_complete_callback(
        [against, of_scan = std::vector(options.begin() + static_cast<std::ptrdiff_t>(before), options.end())]
        { refuse_without(*against, of_scan); });
}

} // namespace voroprobe
