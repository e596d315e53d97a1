#include "cli/label_output.h"

#include <array>
#include <set>

#include "cli/interrupt.h"
#include "cli/output_pattern.h"
#include "io/mesh_label_writer.h"
#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

namespace fs = std::filesystem;

void give_paths(const MeshArguments& arguments, std::vector<LabelOutcome>& labels)
{
    std::vector<PatternValues> values;
    values.reserve(labels.size());
    for (const LabelOutcome& label : labels)
        values.push_back({std::to_string(label.value), label.name});
    const std::vector<fs::path> paths = expand_pattern(arguments.output, values);
    for (std::size_t i = 0; i < labels.size(); ++i)
        labels[i].path = paths[i];
}

} // namespace

LabelOutput::LabelOutput(const MeshArguments& arguments, MeshFormat format, std::vector<LabelOutcome>& labels)
    : arguments_(arguments), format_(format), labels_(labels),
      one_file_(!is_output_pattern(arguments.output) && holds_labels(format))
{
    if (one_file_)
    {
        parts_.resize(labels.size());
        for (LabelOutcome& label : labels)
            label.path = arguments.output;
        return;
    }
    if (!is_output_pattern(arguments.output) && labels.size() > 1)
        throw UsageError("--output is '" + arguments.output.string() + "' for " + count_text(labels.size()) +
                         " labels; allowed: a pattern with {name} or {label}, such as out/{name}.stl, or one "
                         ".3mf, .obj or .ply file for all");
    give_paths(arguments, labels);
}

void LabelOutput::prepare() const
{
    std::set<fs::path> folders;
    for (const LabelOutcome& label : labels_)
    {
        if (!folders.insert(label.path.parent_path()).second)
            continue;
        make_folder_of(label.path);
        check_writable(label.path);
    }
    expect_files(one_file_ ? 1 : labels_.size());
}

std::vector<std::string> LabelOutput::comments() const
{
    return {std::string("voroprobe ") + VOROPROBE_VERSION,
            "unit: " + std::string(frame_unit(arguments_.frame)),
            "frame: " + std::string(frame_name(arguments_.frame))};
}

void LabelOutput::take(const LabelOutcome& label, TriangleMesh mesh)
{
    MeshPart part{.name = label.name, .color = label.color, .mesh = std::move(mesh)};
    if (one_file_)
    {
        parts_[static_cast<std::size_t>(&label - labels_.data())] = std::move(part);
        return;
    }
    write(label, std::move(part));
    note_file_written();
}

void LabelOutput::write(const LabelOutcome& label, MeshPart part) const
{
    if (holds_labels(format_)) // then it holds a name and a colour, too
    {
        write_labels(std::array{std::move(part)}, std::array{label.value}, label.path, format_, comments(),
                     pass_point_of_no_return);
        return;
    }
    std::vector<std::string> lines = comments();
    lines.push_back("label: " + std::to_string(label.value));
    lines.push_back("name: " + label.name);
    write_mesh(part.mesh, label.path, format_, lines, pass_point_of_no_return);
}

void LabelOutput::finish()
{
    if (!one_file_)
        return;
    std::vector<LabelValue> values;
    values.reserve(labels_.size());
    for (const LabelOutcome& label : labels_)
        values.push_back(label.value);
    write_labels(parts_, values, arguments_.output, format_, comments(), pass_point_of_no_return);
    note_file_written();
}

} // namespace voroprobe
