#include "cli/process_arguments.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include <CLI/CLI.hpp>

#include "cli/option_group.h"
#include "cli/option_values.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

const NumberRule kFactor{[](double x) { return x > 0.0; }, "a number > 0"};
const NumberRule kShare{[](double x) { return x > 0.0 && x < 100.0; }, "a percentage above 0 and below 100"};
const NumberRule kDecimationAngle{[](double x) { return x >= 0.0 && x < 60.0; },
                                  "a number from 0 to below 60, degrees"};

constexpr const char* kShapeGroup =
    "Shape (in this order; each step is checked and stops where it breaks a promise)";
constexpr const char* kPlaceGroup = "Place (after the shape, in this order)";

FaceGoal parse_face_goal(const std::string& given)
{
    if (given.ends_with('%'))
        return {.share = 0.01 * parse_number("--decimate", given.substr(0, given.size() - 1), kShare)};
    constexpr std::size_t kFewestFaces = 4;
    return {.count = parse_count("--decimate", given, kFewestFaces)};
}

Vec3 parse_vector(std::string_view option, const std::string& given)
{
    constexpr std::string_view kAllowed = "three numbers separated by commas, mm (x,y,z)";
    static const NumberRule kRule{kAnyFinite.allows, kAllowed};
    Vec3 result;
    std::size_t begin = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const std::size_t end = axis < 2 ? given.find(',', begin) : given.size();
        if (end == std::string::npos)
            refuse_value(option, given, kAllowed);
        try
        {
            result[axis] = parse_number(option, given.substr(begin, end - begin), kRule);
        }
        catch (const UsageError&)
        {
            refuse_value(option, given, kAllowed);
        }
        begin = end + 1;
    }
    return result;
}

//! "x:90": a right-handed turn about an axis through the origin. Quarters of a turn are exact.
AffineTransform parse_rotation(const std::string& given)
{
    constexpr std::string_view kAllowed = "AXIS:DEGREES, as in x:90, z:-12.5";
    static const NumberRule kRule{kAnyFinite.allows, kAllowed};
    if (given.size() < 3 || given[0] < 'x' || given[0] > 'z' || given[1] != ':')
        refuse_value("--rotate", given, kAllowed);
    const double degrees = parse_number("--rotate", given.substr(2), kRule);
    const double quarters = degrees / 90.0;
    const bool is_exact = quarters == std::round(quarters);
    const double angle = degrees * std::numbers::pi / 180.0;
    const double c = is_exact ? std::round(std::cos(angle)) : std::cos(angle);
    const double s = is_exact ? std::round(std::sin(angle)) : std::sin(angle);
    const auto a = static_cast<std::size_t>(given[0] - 'x');
    AffineTransform turn;
    Vec3 first;
    Vec3 second;
    first[(a + 1) % 3] = c;
    first[(a + 2) % 3] = s;
    second[(a + 1) % 3] = -s;
    second[(a + 2) % 3] = c;
    turn.linear.column[(a + 1) % 3] = first;
    turn.linear.column[(a + 2) % 3] = second;
    return turn;
}

void add_shape_options(CLI::App& command, FinishArguments& arguments, OffersSmoothing smoothing)
{
    OptionGroup group(command, kShapeGroup);
    if (smoothing == OffersSmoothing::kYes)
        group.text("--smooth", "N", "Smooth N times, forth and back so that the volume nearly stays (Taubin)",
                   [&arguments](const std::string& given)
                   { arguments.smooth = parse_count("--smooth", given, 1); });
    group.text("--decimate", "N|P%", "Leave N faces, or P % of them",
               [&arguments](const std::string& given) { arguments.decimate = parse_face_goal(given); });
    group.number("--max-error", "MM", arguments.max_error, kLength,
                 "Decimate while points that go stay this near to the faces, mm");
    group.text("--decimate-angle", "DEG",
               "Faces that decimation makes have no smaller angle, degrees, 0 to 60\n(default 20)",
               [&arguments](const std::string& given)
               { arguments.decimate_angle_deg = parse_number("--decimate-angle", given, kDecimationAngle); });
    command
        .add_flag("--relax", arguments.relax,
                  "Raise the angles: move vertices along the surface, flip, collapse, split")
        ->group(kShapeGroup);
    group.number(
        "--max-distance", "MM", arguments.max_distance, kLength,
        "Largest distance between the surfaces before and after a step, mm\n(default: a typical edge "
        "after it)");
}

void add_placement_options(CLI::App& command, PlacementArguments& arguments)
{
    OptionGroup group(command, kPlaceGroup);
    group.text("--scale", "F", "Make everything F times as large, about the origin",
               [&arguments](const std::string& given)
               { arguments.scale = parse_number("--scale", given, kFactor); });
    group
        .text("--rotate", "AXIS:DEG", "Turn about an axis through the origin, x:90; may be given again",
              [&arguments](const std::string& given) { arguments.moves.push_back(parse_rotation(given)); })
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->trigger_on_parse();
    group.text("--translate", "X,Y,Z", "Move, mm; after --rotate where both are given",
               [&arguments](const std::string& given) {
                   arguments.moves.push_back({{}, parse_vector("--translate", given)});
               });
    command.add_flag("--center", arguments.center, "Put the middle of the box to the origin")
        ->group(kPlaceGroup);
    command
        .add_flag("--on-bed", arguments.on_bed,
                  "Put the middle of the box above the origin, the lowest point at z = 0")
        ->group(kPlaceGroup);
}

void add_mending_options(CLI::App& command, ProcessArguments& arguments)
{
    constexpr const char* kGroup = "Mending (first)";
    OptionGroup group(command, kGroup);
    group.choice("--unit", arguments.mm_per_unit,
                 Words<double>{{"mm", 1.0}, {"um", 1e-3}, {"cm", 10.0}, {"m", 1e3}, {"inch", 25.4}},
                 "What a coordinate of MESH is in; it becomes mm (default mm; 3MF\nfiles say it themselves)");
    command
        .add_flag("--repair", arguments.repair, "Drop useless faces, wind all alike and outward, close holes")
        ->group(kGroup);
    group.number("--max-hole", "MM", arguments.max_hole_rim, kLength,
                 "Leave holes with a longer rim open, mm (default: close all)");
}

void add_body_options(CLI::App& command, ProcessArguments& arguments)
{
    constexpr const char* kGroup = "Bodies (next; what is dropped is counted)";
    OptionGroup group(command, kGroup);
    group.number("--min-volume", "MM3", arguments.bodies.min_volume, kVolume, "Drop bodies with less, mm3");
    group.text("--keep-largest", "N", "Drop all but the N with the largest volume",
               [&arguments](const std::string& given)
               { arguments.bodies.keep_largest = parse_count("--keep-largest", given, 1); });
    command.add_flag("--drop-cavities", arguments.bodies.drop_cavities, "Fill the cavities")->group(kGroup);
    command.add_flag("--sort", arguments.sort, "Put the largest body first")->group(kGroup);
    command
        .add_flag("--split", arguments.split,
                  "Write every body by itself: an object each in a .3mf, or a file\neach where OUT has {n} "
                  "in its name")
        ->group(kGroup);
}

void add_hollow_options(CLI::App& command, HollowArguments& arguments)
{
    OptionGroup group(command, "Hollow (after the shape, before the place; z is down the drain)");
    group.number("--hollow", "WALL", arguments.wall, kLength,
                 "Take out what lies deeper than a wall of this thickness, mm; the\nsurface is meshed anew");
    group.number("--drain", "D", arguments.drain, kLength,
                 "Drill a hole of this diameter straight down from the lowest point\nof each hollow, mm "
                 "(default: none)");
    group.number("--voxel", "MM", arguments.voxel, kLength,
                 "Grain of the level set it is done with, mm (default: a quarter of\nthe wall)");
}

} // namespace

void add_finish_options(CLI::App& command, FinishArguments& arguments, OffersSmoothing smoothing)
{
    add_shape_options(command, arguments, smoothing);
    add_placement_options(command, arguments.placement);
}

void add_process_arguments(CLI::App& command, ProcessArguments& arguments)
{
    command.add_option("MESH", arguments.mesh, "Mesh to work on: .stl .ply .obj .off .vtp .3mf")
        ->required()
        ->type_name("");
    add_mending_options(command, arguments);
    add_body_options(command, arguments);
    add_finish_options(command, arguments.finish, OffersSmoothing::kYes);
    add_hollow_options(command, arguments.hollow);
    OptionGroup output(command, "Output");
    output.text("-o,--output", "OUT", "Mesh to write: .stl .ply .obj .off .vtp .3mf (required)",
                [&arguments](const std::string& given) { arguments.output = given; });
    output.text("--format", "NAME", "stl, stl-ascii, ply, obj, off, vtp or 3mf (default: by the extension)",
                [&arguments](const std::string& given) { arguments.format = given; });
    command.add_flag("--normals", arguments.normals, "Write a normal for each vertex (.ply, .obj, .vtp)")
        ->group("Output");
    output.text("--summary", "FILE.json", "Write the steps and what they did as JSON",
                [&arguments](const std::string& given) { arguments.summary = given; });
    command.add_flag("-q,--quiet", arguments.quiet, "No report on stdout; warnings stay")->group("Output");
}

} // namespace voroprobe
