#include "cli/label_map_input.h"

#include <map>
#include <utility>

#include "cli/label_ranges.h"
#include "cli/surface_input.h"
#include "io/volume_reader.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

void refuse_with_labels(bool given, const std::string& option)
{
    if (given)
        throw UsageError(option + " does not go with --labels");
}

std::vector<LabelValue> values_of(const LabelSurvey& survey)
{
    std::vector<LabelValue> values;
    for (const SurveyedLabel& label : survey.labels())
        values.push_back(label.value);
    return values;
}

void require_among(const LabelRanges& ranges, const std::string& option, const std::vector<LabelValue>& there)
{
    if (const std::string strangers = ranges.not_among(there); !strangers.empty())
        throw UsageError(option + " asks for label " + strangers +
                         ", which the label map does not have; allowed: " + labels_text(there));
}

std::map<LabelValue, LabelEntry> table_of(const LabelArguments& arguments)
{
    std::map<LabelValue, LabelEntry> table;
    if (arguments.names)
        for (LabelEntry& entry : read_label_table(*arguments.names))
            table.emplace(entry.value, std::move(entry));
    return table;
}

} // namespace

void check_label_arguments(const MeshArguments& arguments)
{
    const LabelArguments& labels = arguments.label_map;
    if (!labels.wanted())
    {
        for (const auto& [given, option] : {std::pair{labels.exclude.has_value(), "--exclude"},
                                            {labels.smoothing.has_value(), "--smooth"},
                                            {labels.names.has_value(), "--names"}})
            if (given)
                throw UsageError(std::string(option) + " goes with --labels only");
        return;
    }
    refuse_with_labels(arguments.formula.has_value(), "--implicit");
    refuse_with_labels(arguments.isovalue.has_value(), "--isovalue");
    refuse_with_labels(arguments.inside.has_value(), "--inside");
    refuse_with_labels(arguments.border == BorderFaces::kOpen, "--border open");
    refuse_with_labels(arguments.max_vertices.has_value(), "--max-vertices");
    refuse_with_labels(!arguments.selection.keeps_all(),
                       "leaving out surfaces by --min-component-volume, --keep-largest or --drop-cavities");
    const SeedingArguments& finding = arguments.finding;
    refuse_with_labels(finding.seeding || finding.random_points || finding.component_radius ||
                           finding.component_count || finding.seeds || finding.max_seconds || finding.theorem,
                       "the group 'Finding the components'");
    if (is_vdb_path(arguments.input))
        throw UsageError("INPUT is '" + arguments.input.string() + "'; allowed with --labels: dense volumes");
    check_read_options(arguments.input, arguments.read);
}

LabelMap read_label_map(const MeshArguments& arguments)
{
    ReadVolume read = read_volume(arguments.input, arguments.read);
    const GridGeometry& geometry = read.volume.geometry;
    const GridPlacement placement{geometry.world_from_grid, geometry.source_index_from_grid};
    try
    {
        LabelMap map{.survey = LabelSurvey(read.volume),
                     .spacing = geometry.spacing,
                     .placement = placement,
                     .lattice = file_lattice(geometry.size, placement),
                     .format = std::move(read.format),
                     .stored_type = std::move(read.stored_type),
                     .warnings = std::move(read.warnings)};
        if (map.survey.labels().empty())
            throw EmptySurfaceError("no label: all samples are 0, the background");
        return map;
    }
    catch (const InputError& error)
    {
        throw InputError(arguments.input.string() + ": " + error.what());
    }
}

std::vector<LabelOutcome> chosen_labels(const MeshArguments& arguments, const LabelMap& map)
{
    const std::vector<LabelValue> there = values_of(map.survey);
    const LabelRanges wanted("--labels", arguments.label_map.labels.value());
    require_among(wanted, "--labels", there);
    std::optional<LabelRanges> unwanted;
    if (arguments.label_map.exclude)
    {
        unwanted.emplace("--exclude", *arguments.label_map.exclude);
        require_among(*unwanted, "--exclude", there);
    }
    const std::map<LabelValue, LabelEntry> table = table_of(arguments.label_map);
    std::vector<LabelOutcome> chosen;
    for (std::uint32_t place = 0; place < there.size(); ++place)
    {
        const SurveyedLabel& label = map.survey.labels()[place];
        if (!wanted.contains(label.value) || (unwanted && unwanted->contains(label.value)))
            continue;
        LabelOutcome outcome{.value = label.value,
                             .name = "label_" + std::to_string(label.value),
                             .voxels = label.voxels,
                             .parts_expected = label.parts.size(),
                             .path = {}};
        outcome.mesh.label = place;
        if (const auto entry = table.find(label.value); entry != table.end())
        {
            outcome.name = entry->second.name.empty() ? outcome.name : entry->second.name;
            outcome.color = entry->second.color;
        }
        chosen.push_back(std::move(outcome));
    }
    if (chosen.empty())
        throw UsageError("--exclude leaves none of the labels; there are: " + labels_text(there));
    return chosen;
}

} // namespace voroprobe
