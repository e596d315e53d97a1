#include "cli/compare_arguments.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include <CLI/CLI.hpp>

#include "cli/option_group.h"
#include "cli/option_values.h"
#include "cli/read_arguments.h"
#include "compare/contestant_list.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

const NumberRule kSeconds{[](double x) { return x > 0.0; }, "a number > 0, seconds"};

const NumberRule kSecondsOrNone{[](double x) { return x >= 0.0; }, "a number >= 0, seconds"};

//! Surfaces that are large enough to compare have more.
constexpr std::size_t kFewestSamples = 100;

const Words<bool> kOnOff{{"on", true}, {"off", false}};

std::string known_names()
{
    std::string names;
    for (const ContestantEntry& entry : all_contestants())
        names += (names.empty() ? "" : ", ") + entry.name;
    return names;
}

bool is_known(const std::string& name)
{
    const auto all = all_contestants();
    return std::any_of(all.begin(), all.end(),
                       [&](const ContestantEntry& entry) { return entry.name == name; });
}

std::vector<std::string> parse_contestants(const std::string& given)
{
    std::vector<std::string> names;
    std::istringstream list(given);
    for (std::string name; std::getline(list, name, ',');)
    {
        if (!is_known(name))
            refuse_value("--contestants", name, known_names());
        names.push_back(name);
    }
    if (names.empty())
        refuse_value("--contestants", given, known_names());
    return names;
}

bool is_word(const std::string& name)
{
    return !name.empty() &&
           std::all_of(name.begin(), name.end(),
                       [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
}

BroughtMesh parse_with(const std::string& given)
{
    const auto equals = given.find('=');
    const std::string name = given.substr(0, equals);
    if (equals == std::string::npos || !is_word(name) || equals + 1 == given.size())
        refuse_value("--with", given, "NAME=FILE, the name of letters, digits, '-' and '_'");
    if (is_known(name))
        refuse_value("--with", given, "a name that is not one of " + known_names());
    return {name, given.substr(equals + 1)};
}

void add_surface_options(CLI::App& command, CompareArguments& arguments)
{
    OptionGroup group(command, "Surface");
    group.isovalue(arguments.isovalue,
                   "Value of the samples at the surface (default auto: Otsu's threshold)");
    group.inside(arguments.inside, "Side of the isovalue the object lies on (default auto: above)");
}

void add_criteria(CLI::App& command, CompareArguments& arguments)
{
    OptionGroup group(command, "Criteria of Voroprobe and of CGAL's meshers (as for mesh)");
    group.number("--size", "MM", arguments.criteria.size, kLength, "Largest radius of a face's ball, mm");
    group.text("--angle", "DEG", "Smallest angle of a face, degrees, 0 to 30 (default 30)",
               [&arguments](const std::string& given)
               { arguments.criteria.angle_deg = parse_number("--angle", given, kFacetAngle); });
    group.number("--distance", "MM", arguments.criteria.distance, kLength,
                 "Largest distance of a face's circumcenter from the surface, mm");
    group.number("--floor", "MM", arguments.criteria.floor, kLength, "Smallest balls of Voroprobe's, mm");
    group.number("--reach", "MM", arguments.criteria.reach, kLength,
                 "Parts thinner may be missed by probes, mm");
}

void add_contestant_options(CLI::App& command, CompareArguments& arguments)
{
    OptionGroup group(command, "Contestants");
    group.text("--contestants", "A,B,...", "Who takes part (default all):\n" + known_names(),
               [&arguments](const std::string& given) { arguments.contestants = parse_contestants(given); });
    command
        .add_option_function<std::vector<std::string>>(
            "--with",
            [&arguments](const std::vector<std::string>& given)
            {
                for (const std::string& one : given)
                    arguments.with.push_back(parse_with(one));
            },
            "A mesh made elsewhere takes part as well; may be given more than once")
        ->type_name("NAME=FILE")
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all()
        ->group("Contestants");
    group.choice("--frame-of-reference", arguments.frame,
                 Words<OutputFrame>{
                     {"lps", OutputFrame::kLps}, {"ras", OutputFrame::kRas}, {"index", OutputFrame::kIndex}},
                 "Coordinates of the meshes of --with (default lps)");
    group.text("--contestant-seconds", "S", "A contestant that takes longer has failed (default 120)",
               [&arguments](const std::string& given)
               { arguments.contestant_seconds = parse_number("--contestant-seconds", given, kSeconds); });
    group.text(
        "--sweep-seconds", "S",
        "Processor time to run contestants again, to find how many\nvertices they need to be as near to "
        "the scan as marching cubes; 0\nleaves it out (default 16)",
        [&arguments](const std::string& given)
        { arguments.sweep_seconds = parse_number("--sweep-seconds", given, kSecondsOrNone); });
}

void add_output_options(CLI::App& command, CompareArguments& arguments)
{
    OptionGroup group(command, "Output");
    group.text("-o,--output", "PAGE.html",
               "Page to write; .json, .csv, .md and pictures go beside it. With\nseveral "
               "scans: a folder (required)",
               [&arguments](const std::string& given) { arguments.output = given; });
    group.choice("--pictures", arguments.pictures, kOnOff, "Draw a PNG of every mesh (default on)");
}

void add_run_options(CLI::App& command, CompareArguments& arguments)
{
    OptionGroup group(command, "Run");
    group.text("--samples", "N",
               "Points of each mesh to measure distances at, and half as many\nof the scan (default 20000)",
               [&arguments](const std::string& given)
               { arguments.samples = parse_count("--samples", given, kFewestSamples); });
    group.text("--at-once", "N",
               "Contestants that run at the same time, on one thread each\n(default: one per processor)",
               [&arguments](const std::string& given)
               { arguments.at_once = parse_count("--at-once", given, 1); });
    command.add_flag("-q,--quiet", arguments.quiet, "No report on stdout; warnings and errors stay")
        ->group("Run");
}

} // namespace

void add_compare_arguments(CLI::App& command, CompareArguments& arguments)
{
    command
        .add_option("INPUT", arguments.inputs,
                    "Volumes: files, folders with a DICOM series or TIFF slices, or a\nfolder of volumes")
        ->required()
        ->type_name("");
    add_surface_options(command, arguments);
    add_criteria(command, arguments);
    add_label_options(command, arguments.label_map);
    add_contestant_options(command, arguments);
    add_output_options(command, arguments);
    add_read_options(command, arguments.read);
    add_run_options(command, arguments);
}

} // namespace voroprobe
