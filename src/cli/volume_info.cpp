#include "cli/volume_info.h"

#include <nlohmann/json.hpp>

#include "cli/histogram_view.h"
#include "cli/info_text.h"
#include "cli/isovalue_choice.h"
#include "cli/json_values.h"
#include "cli/label_map.h"
#include "cli/number_text.h"
#include "cli/surface_input.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

std::vector<SuggestedIsovalue> suggestions_for(const Volume& volume, const VolumeStatistics& statistics,
                                               bool label_map)
{
    const auto suggestion = [&](double value, std::string source) {
        return SuggestedIsovalue{value, std::move(source), share_inside(volume, value, InsideIs::kAbove)};
    };
    if (label_map)
        return {suggestion(0.5, "everything that is not 0")};
    std::vector<SuggestedIsovalue> suggestions;
    if (const auto automatic = automatic_isovalue(statistics))
        suggestions.push_back(suggestion(automatic->value, automatic->source));
    if (statistics.distinct_values == 2)
        return suggestions;
    constexpr std::size_t kMoreClasses = 3;
    for (const double value : otsu_thresholds(statistics, kMoreClasses))
        suggestions.push_back(suggestion(value, "Otsu, 3 classes"));
    return suggestions;
}

//! Fractions on both sides of 0 and a border that is nearly all positive: scans of matter have air or nothing
//! around them, and that is at most 0 in the units scanners use.
bool looks_like_signed_distance(const Volume& volume, const VolumeStatistics& statistics)
{
    constexpr double kLargestNegativeBorderShare = 0.05;
    return !statistics.integer_valued && statistics.min < 0.0 && statistics.max > 0.0 &&
           border_share_inside(volume, 0.0, InsideIs::kBelow) <= kLargestNegativeBorderShare;
}

std::string distinct_text(std::size_t distinct_values)
{
    return distinct_values == 0 ? "more than 4096" : count_text(distinct_values);
}

bool has_finite_sample(const VolumeInfo& info)
{
    const auto& [x, y, z] = info.lattice.size;
    return info.statistics.nan_count + info.statistics.infinite_count < x * y * z;
}

std::string values_text(const VolumeInfo& info)
{
    const VolumeStatistics& statistics = info.statistics;
    if (!has_finite_sample(info))
        return "no sample is a finite number";
    return number_text(statistics.min) + " to " + number_text(statistics.max) + ", mean " +
           number_text(statistics.mean) + ", " + distinct_text(statistics.distinct_values) + " different" +
           (statistics.integer_valued ? ", whole numbers" : "");
}

std::string suggestion_lines(const std::vector<SuggestedIsovalue>& suggestions)
{
    std::string text;
    for (const SuggestedIsovalue& s : suggestions)
        text += info_line(text.empty() ? "isovalues" : "", number_text(s.value) + " (" + s.source +
                                                               "): " + percent_text(s.share_inside) +
                                                               " of the voxels inside");
    return text.empty() ? info_line("isovalues", "none separates the samples") : text;
}

std::vector<HistogramMark> marks_for(const std::vector<SuggestedIsovalue>& suggestions)
{
    std::vector<HistogramMark> marks;
    marks.reserve(suggestions.size());
    for (const SuggestedIsovalue& s : suggestions)
        marks.push_back({s.value, number_text(s.value) + " (" + s.source + ')'});
    return marks;
}

} // namespace

VolumeInfo volume_info(const std::filesystem::path& path, const ReadOptions& options)
{
    ReadVolume read = read_volume(path, options);
    const GridGeometry& geometry = read.volume.geometry;
    VolumeInfo info{
        .path = path.string(),
        .format = std::move(read.format),
        .stored_type = std::move(read.stored_type),
        .lattice = file_lattice(geometry.size, {geometry.world_from_grid, geometry.source_index_from_grid}),
        .statistics = compute_statistics(read.volume),
        .suggestions = {},
        .warnings = std::move(read.warnings)};
    info.label_map = looks_like_label_map(read.volume, info.statistics);
    info.signed_distance = looks_like_signed_distance(read.volume, info.statistics);
    info.suggestions = suggestions_for(read.volume, info.statistics, info.label_map);
    return info;
}

std::string volume_info_text(const VolumeInfo& info)
{
    const VolumeStatistics& statistics = info.statistics;
    std::string text = info_line("file", info.path + " (" + info.format + ", " + info.stored_type + ")") +
                       lattice_lines(info.lattice) + info_line("values", values_text(info)) +
                       info_line("not finite", count_text(statistics.nan_count) + " NaN, " +
                                                   count_text(statistics.infinite_count) + " infinite");
    if (info.label_map)
        text += info_line("note", "looks like a label map: mesh it with --labels all, or give --isovalue, "
                                  "0.5 for everything that is "
                                  "not 0");
    if (info.signed_distance)
        text += info_line("note", "looks like a signed distance: give --isovalue 0 --inside below");
    text += suggestion_lines(info.suggestions);
    const std::string histogram = histogram_view(statistics, marks_for(info.suggestions));
    return histogram.empty()
               ? text
               : text + "\n  histogram (rows begin at the value shown, bars are logarithmic)\n" + histogram;
}

std::string volume_info_json(const VolumeInfo& info)
{
    const VolumeStatistics& statistics = info.statistics;
    Json suggestions = Json::array();
    for (const SuggestedIsovalue& s : info.suggestions)
        suggestions.push_back({{"value", s.value}, {"source", s.source}, {"share_inside", s.share_inside}});
    Json json = lattice_json(info.path, info.format, info.stored_type, info.lattice);
    const auto if_finite = [finite = has_finite_sample(info)](double value)
    { return finite ? Json(value) : Json(nullptr); };
    json["min"] = if_finite(statistics.min);
    json["max"] = if_finite(statistics.max);
    json["mean"] = if_finite(statistics.mean);
    json["nan_count"] = statistics.nan_count;
    json["infinite_count"] = statistics.infinite_count;
    json["integer_valued"] = statistics.integer_valued;
    json["distinct_values"] =
        statistics.distinct_values > 0 ? Json(statistics.distinct_values) : Json(nullptr);
    json["label_map"] = info.label_map;
    json["signed_distance"] = info.signed_distance;
    json["suggested_isovalues"] = suggestions;
    json["histogram"] = statistics.histogram;
    json["warnings"] = info.warnings;
    return json_text(json) + '\n';
}

} // namespace voroprobe
