#include "cli/label_arguments.h"

#include <string_view>

#include <CLI/CLI.hpp>

#include "cli/label_ranges.h"
#include "cli/option_group.h"
#include "cli/option_values.h"

namespace voroprobe
{
namespace
{

constexpr std::string_view kGaussian = "gaussian";

LabelSmoothing parse_smoothing(const std::string& given)
{
    if (given == "none")
        return {.method = SmoothingMethod::kNone};
    if (given == "antialias")
        return {.method = SmoothingMethod::kAntialias};
    if (given == "joint")
        return {.method = SmoothingMethod::kJoint};
    if (given == kGaussian)
        return {.method = SmoothingMethod::kGaussian};
    if (given.starts_with(std::string(kGaussian) + ':'))
        return {.method = SmoothingMethod::kGaussian,
                .sigma = parse_number("--smooth gaussian",
                                      std::string_view(given).substr(kGaussian.size() + 1), kLength)};
    refuse_value("--smooth", given, "none, gaussian, gaussian:SIGMA (mm), antialias or joint");
}

} // namespace

void add_label_options(CLI::App& command, LabelArguments& arguments)
{
    OptionGroup group(command, "Label maps");
    group.text("--labels", "all|1,5,7-9",
               "Mesh each of these labels of a segmentation by itself, in place of\nan isovalue",
               [&arguments](const std::string& given)
               {
                   const LabelRanges readable("--labels", given); // refuses what it cannot read
                   arguments.labels = given;
               });
    group.text("--exclude", "1,5,7-9", "But for these",
               [&arguments](const std::string& given)
               {
                   const LabelRanges readable("--exclude", given);
                   arguments.exclude = given;
               });
    group.text("--smooth", "none|gaussian:SIGMA|antialias|joint",
               "How the staircase of voxels is smoothed; SIGMA in mm (default\ngaussian: SIGMA 1 m)",
               [&arguments](const std::string& given) { arguments.smoothing = parse_smoothing(given); });
    group.text("--max-labels", "N",
               "Refuse more labels than that (default 10000; 100 where the image\nlooks like a scan)",
               [&arguments](const std::string& given)
               { arguments.most_labels = parse_count("--max-labels", given, 1); });
}

void add_label_mesh_options(CLI::App& command, LabelArguments& arguments)
{
    OptionGroup group(command, "Label maps");
    command
        .add_flag("--shared-interfaces", arguments.shared_interfaces,
                  "Neighbours have the same triangles where they touch (--smooth\njoint says the same)")
        ->group("Label maps");
    group.text(
        "--names", "FILE",
        "Names and colours of the labels: ITK-SNAP, FreeSurfer, Slicer\n(.ctbl), or `number name` lines",
        [&arguments](const std::string& given) { arguments.names = given; });
}

} // namespace voroprobe
