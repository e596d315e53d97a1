#include "cli/label_arguments.h"

#include <string_view>

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
    if (given == kGaussian)
        return {.method = SmoothingMethod::kGaussian};
    if (given.starts_with(std::string(kGaussian) + ':'))
        return {.method = SmoothingMethod::kGaussian,
                .sigma = parse_number("--smooth gaussian",
                                      std::string_view(given).substr(kGaussian.size() + 1), kLength)};
    refuse_value("--smooth", given, "none, gaussian, gaussian:SIGMA (mm) or antialias");
}

} // namespace

void add_label_options(CLI::App& command, LabelArguments& arguments)
{
    OptionGroup group(command, "Label maps");
    group.text("--labels", "all|1,5,7-9",
               "Mesh each of these labels of a segmentation by itself, in place of\nan isovalue",
               [&arguments](const std::string& given)
               {
                   LabelRanges("--labels", given); // refuses what it cannot read
                   arguments.labels = given;
               });
    group.text("--exclude", "1,5,7-9", "But for these",
               [&arguments](const std::string& given)
               {
                   LabelRanges("--exclude", given);
                   arguments.exclude = given;
               });
    group.text("--smooth", "none|gaussian:SIGMA|antialias",
               "How the staircase of voxels is smoothed; SIGMA in mm (default\ngaussian: SIGMA 1 m)",
               [&arguments](const std::string& given) { arguments.smoothing = parse_smoothing(given); });
    group.text(
        "--names", "FILE",
        "Names and colours of the labels: ITK-SNAP, FreeSurfer, Slicer\n(.ctbl), or `number name` lines",
        [&arguments](const std::string& given) { arguments.names = given; });
}

} // namespace voroprobe
