#include "cli/process_command.h"

#include <algorithm>
#include <iostream>
#include <string>
#include <utility>

#include "certificate/mesh_check.h"
#include "cli/distinct_files.h"
#include "cli/info_text.h"
#include "cli/interrupt.h"
#include "cli/normals_argument.h"
#include "cli/number_text.h"
#include "cli/output_pattern.h"
#include "cli/process_steps.h"
#include "cli/process_summary.h"
#include "cli/summary.h"
#include "cli/warnings.h"
#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

namespace fs = std::filesystem;

constexpr std::string_view kNumberInName = "{n}";

fs::path numbered(const fs::path& pattern, std::size_t number)
{
    std::string name = pattern.string();
    name.replace(name.find(kNumberInName), kNumberInName.size(), std::to_string(number));
    return name;
}

bool has_number(const fs::path& pattern)
{
    return pattern.filename().string().find(kNumberInName) != std::string::npos;
}

bool writes_many(const ProcessArguments& arguments)
{
    return arguments.split && has_number(arguments.output);
}

//! `bodies`: how many files there are, where each body has its own.
void check_files(const ProcessArguments& arguments, std::size_t bodies)
{
    std::vector<NamedFile> outputs;
    if (!writes_many(arguments))
        outputs.push_back({"OUT", arguments.output});
    else
        for (std::size_t n = 1; n <= bodies; ++n)
            outputs.push_back({"OUT for body " + std::to_string(n), numbered(arguments.output, n)});
    if (arguments.summary)
        outputs.push_back({"--summary", *arguments.summary});
    check_distinct({{"MESH", arguments.mesh}}, outputs);
}

//! Everything that can be refused before the mesh is read.
MeshFormat check_outputs(const ProcessArguments& arguments)
{
    if (arguments.output.empty())
        throw UsageError("--output is required (see voroprobe process --help)");
    const MeshFormat format = mesh_format(arguments.output, arguments.format);
    normals_argument(arguments.normals, format);
    if (arguments.split && !writes_many(arguments) && format != MeshFormat::k3mf)
        throw UsageError(
            "--split goes with a .3mf, which holds an object for every body, or with {n} in the name of "
            "the output; it is '" +
            arguments.output.string() + "'");
    if (has_number(arguments.output) && !arguments.split)
        throw UsageError("--output is '" + arguments.output.string() +
                         "', with {n}; allowed: only with --split");
    if (arguments.max_hole_rim && !arguments.repair)
        throw UsageError("--max-hole is " + number_text(*arguments.max_hole_rim) +
                         "; allowed: only with --repair");
    constexpr std::size_t kLeastBodies = 1;
    check_files(arguments, kLeastBodies);
    if ((arguments.hollow.drain || arguments.hollow.voxel) && !arguments.hollow.wall)
        throw UsageError("--drain and --voxel go with --hollow WALL only");
    const fs::path first = writes_many(arguments) ? numbered(arguments.output, 1) : arguments.output;
    if (writes_many(arguments))
        make_folder_of(first);
    check_writable(first);
    if (arguments.summary)
        check_writable(*arguments.summary);
    return format;
}

std::vector<std::string> comments()
{
    return {std::string("voroprobe ") + VOROPROBE_VERSION, "unit: mm"};
}

std::vector<fs::path> write(const std::vector<MeshPart>& parts, const ProcessArguments& arguments,
                            MeshFormat format)
{
    std::vector<fs::path> written;
    if (writes_many(arguments))
    {
        expect_files(parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i)
        {
            written.push_back(numbered(arguments.output, i + 1));
            write_mesh(parts[i].mesh, written.back(), format, comments(), pass_point_of_no_return,
                       normals_argument(arguments.normals, format));
            note_file_written();
        }
    }
    else if (format == MeshFormat::k3mf)
        write_parts(parts, arguments.output, comments(), pass_point_of_no_return);
    else
        write_mesh(merged(parts), arguments.output, format, comments(), pass_point_of_no_return,
                   normals_argument(arguments.normals, format));
    return written.empty() ? std::vector<fs::path>{arguments.output} : written;
}

//! Faces of different objects may touch: every object is judged by itself.
std::optional<std::string> what_is_wrong(const std::vector<MeshPart>& parts)
{
    for (const MeshPart& part : parts)
        if (const auto wrong = defects(check_mesh(part.mesh)))
            return *wrong + (parts.size() > 1 ? " (object '" + part.name + "')" : "");
    return std::nullopt;
}

std::string result_lines(const ProcessRun& run)
{
    std::string text = info_line("input", run.arguments.mesh.string());
    text += info_line("", plural_text(run.objects_read, "object") + ", " + facts_text(run.before));
    text += step_lines(run.steps);
    text += info_line("result", plural_text(run.objects_written, "object") + ", " + facts_text(run.after));
    text += info_line("box", triple_text(run.after.box.extent()) + " mm, from (" +
                                 triple_text(run.after.box.min, ", ") + ") to (" +
                                 triple_text(run.after.box.max, ", ") + ")");
    for (const fs::path& path : run.written)
        text += info_line(path == run.written.front() ? "written" : "", path.string());
    return text;
}

} // namespace

void run_process_command(const ProcessArguments& arguments)
{
    const MeshFormat format = check_outputs(arguments);
    std::vector<MeshPart> parts = read_parts(arguments.mesh);
    ProcessRun run{.arguments = arguments, .objects_read = parts.size(), .before = facts_of(parts)};
    parts = mend(std::move(parts), arguments, run.steps);
    check_files(arguments, parts.size());
    for (MeshPart& part : parts)
        part.mesh = finish(std::move(part.mesh), arguments.finish, parts.size() > 1 ? part.name : "", nullptr,
                           run.steps);
    for (MeshPart& part : parts)
        part.mesh =
            hollow(std::move(part.mesh), arguments.hollow, parts.size() > 1 ? part.name : "", run.steps);
    place(parts, arguments.finish.placement);
    run.objects_written = parts.size();
    run.after = facts_of(parts);
    run.wrong = what_is_wrong(parts);
    run.written = write(parts, arguments, format);

    if (arguments.summary)
        write_text(*arguments.summary, process_json(run));
    if (!arguments.quiet)
        std::cout << result_lines(run);
    if (run.wrong)
        throw Error(ExitStatus::kIncomplete,
                    arguments.output.string() + " was written but has " + *run.wrong);
}

} // namespace voroprobe
