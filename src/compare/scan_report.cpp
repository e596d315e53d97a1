#include "compare/scan_report.h"

#include <algorithm>
#include <fstream>
#include <thread>

#include <nlohmann/json.hpp>

#include "compare/competition.h"
#include "compare/equal_accuracy.h"
#include "compare/label_competition.h"
#include "compare/label_frame.h"
#include "compare/library_versions.h"
#include "compare/measurement.h"
#include "compare/report_page.h"
#include "compare/report_text.h"
#include "support/memory.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

//! What is the same whatever the samples mean.
Json file_json(const ScanFacts& facts)
{
    return {{"name", facts.name},        {"path", facts.path}, {"format", facts.format},
            {"type", facts.stored_type}, {"size", facts.size}, {"spacing_mm", to_json(facts.spacing)},
            {"warnings", facts.warnings}};
}

Json input_json(const ScanFacts& facts, const MeshingTask& task)
{
    Json json = file_json(facts);
    json["min"] = facts.min;
    json["max"] = facts.max;
    json["isovalue"] = task.isovalue;
    json["isovalue_source"] = facts.isovalue_source;
    json["inside"] = task.inside == InsideIs::kAbove ? "above" : "below";
    return json;
}

Json input_json(const ScanFacts& facts, const LabelTask& task)
{
    Json json = file_json(facts);
    json["labels"] = task.labels.size();
    return json;
}

Json parameters_json(const Json& criteria, const CompetitionOptions& options)
{
    Json json = criteria;
    json.update({{"samples", options.measuring.mesh_samples},
                 {"contestant_seconds", options.contestant_seconds},
                 {"sweep_seconds", options.sweep_seconds},
                 {"at_once", options.at_once}});
    return json;
}

Json criteria_json(const MeshingTask& task)
{
    return {{"size_mm", task.max_facet_radius},
            {"angle_deg", task.min_facet_angle_deg},
            {"distance_mm", task.max_facet_distance},
            {"floor_mm", task.floor_radius},
            {"reach_mm", task.reach}};
}

const char* smoothing_name(SmoothingMethod method)
{
    switch (method)
    {
    case SmoothingMethod::kNone:
        return "none";
    case SmoothingMethod::kGaussian:
        return "gaussian";
    case SmoothingMethod::kAntialias:
        return "antialias";
    case SmoothingMethod::kJoint:
        break;
    }
    return "joint";
}

Json criteria_json(const LabelMeshingOptions& options)
{
    const MeshingOptions& criteria = options.criteria;
    Json json = {{"size_mm", criteria.max_facet_radius},
                 {"angle_deg", criteria.min_facet_angle_deg},
                 {"distance_mm", criteria.max_facet_distance.value_or(0.0)},
                 {"floor_mm", criteria.floor_radius},
                 {"reach_mm", criteria.reach_lower_bound},
                 {"smoothing", smoothing_name(options.smoothing.method)}};
    if (options.smoothing.method == SmoothingMethod::kGaussian)
        json["sigma_mm"] = options.smoothing.sigma;
    return json;
}

//! "model name" of the first processor; empty where the system does not tell.
std::string processor_name()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            return line.substr(std::min(line.size(), line.find(':') + 2));
    return {};
}

Json machine_json()
{
    return {{"processor", processor_name()},
            {"processors", std::thread::hardware_concurrency()},
            {"memory_bytes", total_memory_bytes()}};
}

Json surfaces_json(const ReferenceSurface& reference)
{
    Json list = Json::array();
    const auto& surfaces = reference.inventory->surfaces();
    for (std::size_t id = 0; id < surfaces.size(); ++id)
        list.push_back({{"id", id},
                        {"voxels", surfaces[id].enclosed_samples},
                        {"cavity", surfaces[id].cavity},
                        {"touches_border", surfaces[id].touches_border},
                        {"genus", (2 - surfaces[id].euler_characteristic) / 2},
                        {"center_mm", to_json(reference.world_from_grid * surfaces[id].box.center())},
                        {"size_mm", to_json(surfaces[id].box.extent())}});
    return list;
}

//! The parts of the labels, by the names of surfaces: the page lists them alike. Handles of parts are not
//! counted.
Json parts_json(const LabelTask& task)
{
    Json list = Json::array();
    for (const std::uint32_t label : task.labels)
        for (const std::uint32_t id : task.survey->labels()[label].parts)
        {
            const LabelPart& part = task.survey->parts()[id];
            const Box3 box = world_box(task, part.box);
            const auto& last = part.box.last;
            const auto& size = task.survey->size();
            const bool touches_border = part.box.first[0] == 0 || part.box.first[1] == 0 ||
                                        part.box.first[2] == 0 || last[0] + 1 == size[0] ||
                                        last[1] + 1 == size[1] || last[2] + 1 == size[2];
            list.push_back({{"id", id},
                            {"label", task.survey->labels()[label].value},
                            {"voxels", part.voxels},
                            {"cavity", false},
                            {"touches_border", touches_border},
                            {"center_mm", to_json(box.center())},
                            {"size_mm", to_json(box.extent())}});
        }
    return list;
}

Json contestants_json(std::vector<ContestantOutcome>& outcomes, const std::string& stem, ScanReport& result)
{
    Json contestants = Json::array();
    for (ContestantOutcome& outcome : outcomes)
    {
        if (!outcome.picture.empty())
        {
            const std::string file = stem + "_" + outcome.entry.name + ".png";
            outcome.report["picture"] = file;
            result.pictures.emplace_back(file, std::move(outcome.picture));
        }
        contestants.push_back(outcome.report);
    }
    return contestants;
}

std::vector<PageView> page_views(const std::vector<ContestantOutcome>& outcomes)
{
    std::vector<PageView> views;
    for (const ContestantOutcome& outcome : outcomes)
        if (!outcome.view.empty())
            views.push_back({outcome.entry.name, outcome.view});
    return views;
}

//! `particular`: what depends on the kind of input.
ScanReport assembled(const ScanFacts& facts, const Json& particular, std::vector<ContestantOutcome>& outcomes)
{
    ScanReport result;
    Json report = {{"version", facts.version},
                   {"headline", ""},
                   {"command", facts.command},
                   {"date", facts.date},
                   {"machine", machine_json()},
                   {"libraries", library_versions()},
                   {"pictures_missing", facts.no_pictures ? Json(*facts.no_pictures) : Json(nullptr)}};
    report.update(particular);
    report["contestants"] = contestants_json(outcomes, facts.stem, result);
    result.headline = headline(report);
    report["headline"] = result.headline;
    result.json = report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
    result.csv = report_csv(report);
    result.markdown = report_markdown(report);
    result.table = report_table(report);
    result.page = report_page(report, page_views(outcomes));
    return result;
}

} // namespace

ScanReport make_scan_report(const ScanFacts& facts, const std::vector<ContestantEntry>& entries,
                            const MeshingTask& task, const ReferenceSurface& reference,
                            const CompetitionOptions& options)
{
    std::vector<ContestantOutcome> outcomes = compete(entries, task, reference, options);
    const Json equal =
        options.sweep_seconds > 0.0 ? equal_accuracy(outcomes, task, reference, options) : Json(nullptr);
    return assembled(facts,
                     {{"input", input_json(facts, task)},
                      {"parameters", parameters_json(criteria_json(task), options)},
                      {"voxel_mm", reference.voxel},
                      {"surfaces", surfaces_json(reference)},
                      {"equal_accuracy", equal}},
                     outcomes);
}

ScanReport make_label_report(const ScanFacts& facts, const std::vector<LabelContestantEntry>& entries,
                             const LabelTask& task, const CompetitionOptions& options)
{
    std::vector<ContestantOutcome> outcomes = compete_on_labels(entries, task, options);
    return assembled(facts,
                     {{"input", input_json(facts, task)},
                      {"parameters", parameters_json(criteria_json(task.options), options)},
                      {"voxel_mm", task.voxel},
                      {"surfaces", parts_json(task)},
                      {"equal_accuracy", nullptr}},
                     outcomes);
}

std::string report_index(const std::vector<std::pair<std::string, std::string>>& pages)
{
    std::vector<std::pair<std::string, Json>> parsed;
    parsed.reserve(pages.size());
    for (const auto& [file, json] : pages)
        parsed.emplace_back(file, Json::parse(json));
    return index_page(parsed);
}

} // namespace voroprobe
