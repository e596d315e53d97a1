#include "cli/label_map_input.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "cli/label_map.h"
#include "cli/label_ranges.h"
#include "cli/mesh_budget.h"
#include "cli/mesh_defaults.h"
#include "cli/surface_input.h"
#include "io/volume_reader.h"
#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

constexpr double kDefaultSigmaInMeanSides = 1.0;

//! Atlases and cell segmentations have up to thousands.
constexpr std::size_t kMostLabels = 10'000;

constexpr std::size_t kMostLabelsOfScan = 100;

void refuse_with_labels(bool given, const std::string& option)
{
    if (given)
        throw UsageError(option + " does not go with --labels");
}

//! Of all layers, ascending.
std::vector<LabelValue> values_of(const LabelMap& map)
{
    std::set<LabelValue> values;
    for (const LabelSurvey& layer : map.layers)
        for (const SurveyedLabel& label : layer.labels())
            values.insert(label.value);
    return {values.begin(), values.end()};
}

void require_among(const LabelRanges& ranges, const std::string& option, const std::vector<LabelValue>& there)
{
    if (const std::string strangers = ranges.not_among(there); !strangers.empty())
        throw UsageError(option + " asks for label " + strangers +
                         ", which the label map does not have; allowed: " + labels_text(there));
}

//! What the labels are called: a table that the user gives counts more than the file's own.
class NameTable
{
public:
    NameTable(const LabelArguments& arguments, const std::vector<Segment>& segments)
    {
        for (const Segment& segment : segments)
            of_segments_.emplace(std::pair{segment.layer, segment.entry.value}, segment.entry);
        if (arguments.names)
            for (LabelEntry& entry : read_label_table(*arguments.names))
                of_table_.emplace(entry.value, std::move(entry));
    }

    void name(LabelOutcome& label) const
    {
        label.name = "label_" + std::to_string(label.value);
        if (const auto segment = of_segments_.find({label.layer, label.value}); segment != of_segments_.end())
            apply(segment->second, label);
        if (const auto entry = of_table_.find(label.value); entry != of_table_.end())
            apply(entry->second, label);
    }

private:
    static void apply(const LabelEntry& entry, LabelOutcome& label)
    {
        label.name = entry.name.empty() ? label.name : entry.name;
        label.color = entry.color ? entry.color : label.color;
    }

    std::map<std::pair<std::size_t, LabelValue>, LabelEntry> of_segments_;
    std::map<LabelValue, LabelEntry> of_table_;
};

//! The segments of the file; of the layer that the user chose, if one was chosen, as those of layer 0.
std::vector<Segment> segments_of(const MeshArguments& arguments)
{
    std::vector<Segment> segments = read_segments(arguments.input);
    if (const auto chosen = arguments.read.frame)
    {
        std::erase_if(segments, [&](const Segment& segment) { return segment.layer != *chosen; });
        for (Segment& segment : segments)
            segment.layer = 0;
    }
    return segments;
}

//! Layers that the segments lie in; at least one.
std::size_t count_layers(const std::vector<Segment>& segments)
{
    std::size_t layers = 1;
    for (const Segment& segment : segments)
        layers = std::max(layers, segment.layer + 1);
    return layers;
}

//! Of segments that the file names and that have no voxel.
std::vector<std::string> empty_segment_warnings(const LabelMap& map)
{
    std::vector<std::string> warnings;
    for (const Segment& segment : map.segments)
    {
        const auto& labels = map.layers[segment.layer].labels();
        if (std::none_of(labels.begin(), labels.end(),
                         [&](const SurveyedLabel& label) { return label.value == segment.entry.value; }))
            warnings.push_back("segment '" + segment.entry.name + "' (label " +
                               std::to_string(segment.entry.value) +
                               ") has no voxels: there is no mesh of it");
    }
    return warnings;
}

LabelSurvey survey_of(const Volume& volume, const std::filesystem::path& path)
{
    try
    {
        return LabelSurvey(volume);
    }
    catch (const InputError& error)
    {
        throw InputError(path.string() + ": " + error.what());
    }
}

//! \throw UsageError where there are more labels than anybody is likely to want, before they take hours.
void check_count(const MeshArguments& arguments, const LabelMap& map, std::size_t labels)
{
    const std::size_t most =
        arguments.label_map.most_labels.value_or(map.looks_like_scan ? kMostLabelsOfScan : kMostLabels);
    if (labels <= most)
        return;
    const std::string look = map.looks_like_scan
                                 ? ", where neighbours are seldom equal: this looks like a gray-level scan, "
                                   "not a label map (--isovalue meshes a scan)"
                                 : "";
    throw UsageError("--labels asks for " + count_text(labels) + " labels of '" + arguments.input.string() +
                     "'" + look + "; allowed: " + count_text(most) +
                     " labels, fewer chosen by --labels and --exclude, or --max-labels " +
                     std::to_string(labels) + " to mesh them all the same");
}

} // namespace

void check_label_arguments(const MeshArguments& arguments)
{
    const LabelArguments& labels = arguments.label_map;
    if (!labels.wanted())
    {
        for (const auto& [given, option] : {std::pair{labels.exclude.has_value(), "--exclude"},
                                            {labels.shared_interfaces, "--shared-interfaces"},
                                            {labels.smoothing.has_value(), "--smooth"},
                                            {labels.names.has_value(), "--names"},
                                            {labels.most_labels.has_value(), "--max-labels"}})
            if (given)
                throw UsageError(std::string(option) + " goes with --labels only");
        return;
    }
    if (labels.shared_interfaces && labels.smoothing && labels.smoothing->method != SmoothingMethod::kJoint)
        throw UsageError("--smooth smooths each label by itself; allowed with --shared-interfaces: joint");
    refuse_with_labels(arguments.formula.has_value(), "--implicit");
    refuse_with_labels(arguments.isovalue.has_value(), "--isovalue");
    refuse_with_labels(arguments.inside.has_value(), "--inside");
    refuse_with_labels(arguments.border == BorderFaces::kOpen, "--border open");
    refuse_with_labels(arguments.normals, "--normals");
    refuse_with_labels(arguments.max_vertices.has_value(), "--max-vertices");
    refuse_with_labels(!arguments.selection.keeps_all(),
                       "leaving out surfaces by --min-component-volume, --keep-largest or --drop-cavities");
    refuse_with_labels(arguments.finish.changes_shape() || !arguments.finish.placement.keeps_all(),
                       "working on the mesh (--decimate, --relax, --scale and so on; see process)");
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
    LabelMap map;
    map.segments = segments_of(arguments);
    const std::size_t layers = count_layers(map.segments);
    for (std::size_t layer = 0; layer < layers; ++layer)
    {
        ReadOptions options = arguments.read;
        if (layers > 1)
            options.frame = layer;
        ReadVolume read = read_volume(arguments.input, options);
        map.layers.push_back(survey_of(read.volume, arguments.input));
        if (layer > 0)
            continue;
        const GridGeometry& geometry = read.volume.geometry;
        map.spacing = geometry.spacing;
        map.placement = {geometry.world_from_grid, geometry.source_index_from_grid};
        map.lattice = file_lattice(geometry.size, map.placement);
        map.format = std::move(read.format);
        map.stored_type = std::move(read.stored_type);
        map.warnings = std::move(read.warnings);
        map.looks_like_scan = looks_like_scan(read.volume, map.label_count());
    }
    for (std::string& warning : empty_segment_warnings(map))
        map.warnings.push_back(std::move(warning));
    if (map.label_count() == 0)
        throw EmptySurfaceError("no label: all samples are 0, the background");
    return map;
}

std::vector<LabelOutcome> chosen_labels(const MeshArguments& arguments, const LabelMap& map)
{
    const std::vector<LabelValue> there = values_of(map);
    const LabelRanges wanted("--labels", arguments.label_map.labels.value());
    require_among(wanted, "--labels", there);
    std::optional<LabelRanges> unwanted;
    if (arguments.label_map.exclude)
    {
        unwanted.emplace("--exclude", *arguments.label_map.exclude);
        require_among(*unwanted, "--exclude", there);
    }
    const NameTable names(arguments.label_map, map.segments);
    std::vector<LabelOutcome> chosen;
    for (std::size_t layer = 0; layer < map.layers.size(); ++layer)
        for (std::uint32_t place = 0; place < map.layers[layer].labels().size(); ++place)
        {
            const SurveyedLabel& label = map.layers[layer].labels()[place];
            if (!wanted.contains(label.value) || (unwanted && unwanted->contains(label.value)))
                continue;
            LabelOutcome outcome{.layer = layer,
                                 .value = label.value,
                                 .name = {},
                                 .voxels = label.voxels,
                                 .parts_expected = label.parts.size(),
                                 .path = {}};
            outcome.mesh.label = place;
            names.name(outcome);
            chosen.push_back(std::move(outcome));
        }
    check_count(arguments, map, chosen.size());
    if (chosen.empty())
        throw UsageError("--exclude leaves none of the labels; there are: " + labels_text(there));
    return chosen;
}

LabelMeshingOptions label_meshing_options(const MeshArguments& arguments, const LabelMap& map,
                                          std::size_t threads)
{
    const VoxelScale voxel = voxel_scale(map.placement.source_index_from_grid);
    LabelMeshingOptions options{.criteria = meshing_options(arguments.criteria, voxel),
                                .smoothing = arguments.label_map.smoothing.value_or(
                                    LabelSmoothing{.method = SmoothingMethod::kGaussian})};
    if (arguments.label_map.shared_interfaces)
        options.smoothing.method = SmoothingMethod::kJoint;
    options.criteria.max_vertices = std::max<std::size_t>(1, vertices_in_memory() / threads);
    options.criteria.isolated_vertices = arguments.isolated_vertices;
    if (options.smoothing.sigma == 0.0)
        options.smoothing.sigma = kDefaultSigmaInMeanSides * voxel.mean_side;
    return options;
}

} // namespace voroprobe
