#include "cli/compare_command.h"

#include <algorithm>
#include <iostream>

#include "cli/compare_labels.h"
#include "cli/compare_scan.h"
#include "cli/distinct_files.h"
#include "cli/summary.h"
#include "cli/surface_input.h"
#include "cli/warnings.h"
#include "compare/one_thread.h"
#include "compare/virtual_display.h"
#include "io/mesh_writer.h"
#include "support/error.h"
#include "support/text.h"

namespace voroprobe
{

namespace
{

namespace fs = std::filesystem;

//! Names of files in a folder that are scans by themselves.
bool is_volume_name(const fs::path& path)
{
    const std::string name = lower_case(path.filename().string());
    const auto ends = {".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd", ".inr", ".inr.gz", ".vti"};
    return std::any_of(ends.begin(), ends.end(), [&](const char* end) { return name.ends_with(end); });
}

//! What there is to compare, and whether OUTPUT is one page or a folder for them.
struct Scans
{
    std::vector<fs::path> paths;
    bool into_folder;
};

//! In the order of their names; none where the path is no folder, or one of DICOM or TIFF slices.
std::vector<fs::path> volumes_in(const fs::path& folder)
{
    std::vector<fs::path> volumes;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
        if (entry.is_regular_file(none) && is_volume_name(entry.path()))
            volumes.push_back(entry.path());
    std::sort(volumes.begin(), volumes.end());
    return volumes;
}

//! A folder that holds volumes stands for them, any other path for itself.
Scans scans_of(const std::vector<fs::path>& inputs)
{
    Scans scans{.paths = {}, .into_folder = inputs.size() > 1};
    for (const fs::path& input : inputs)
    {
        const std::vector<fs::path> inside = volumes_in(input);
        scans.into_folder |= !inside.empty();
        scans.paths.insert(scans.paths.end(), inside.begin(), inside.end());
        if (inside.empty())
            scans.paths.push_back(input);
    }
    return scans;
}

//! "scan.nii.gz" without what tells the format.
std::string stem_of(const fs::path& path)
{
    fs::path name = path.filename().empty() ? path.parent_path().filename() : path.filename();
    if (name.extension() == ".gz")
        name = name.stem();
    return name.has_stem() && !fs::is_directory(path) ? name.stem().string() : name.string();
}

//! Where the files of one scan go: the page, and others by its name.
struct Outputs
{
    fs::path page;

    [[nodiscard]] fs::path beside(const std::string& ending) const
    {
        return page.parent_path() / (page.stem().string() + ending);
    }
};

Outputs outputs_of(const CompareArguments& arguments, const Scans& scans, const fs::path& scan)
{
    return {scans.into_folder ? arguments.output / (stem_of(scan) + ".html") : arguments.output};
}

void check_files(const CompareArguments& arguments, const Scans& scans)
{
    std::vector<NamedFile> inputs;
    for (const BroughtMesh& mesh : arguments.with)
        inputs.push_back({"--with " + mesh.name, mesh.path});
    std::vector<NamedFile> files;
    if (scans.into_folder)
        files.push_back({"the index", arguments.output / "index.html"});
    for (const fs::path& scan : scans.paths)
    {
        inputs.push_back({"INPUT", scan});
        const Outputs outputs = outputs_of(arguments, scans, scan);
        files.push_back({"the page of " + scan.string(), outputs.page});
        for (const char* ending : {".json", ".csv", ".md"})
            files.push_back(
                {"the " + std::string(ending) + " file of " + scan.string(), outputs.beside(ending)});
    }
    check_distinct(inputs, files);
}

ScanReport compare_into(const Outputs& outputs, const CompareArguments& arguments, const fs::path& scan,
                        const std::optional<std::string>& no_pictures)
{
    const auto compare = arguments.label_map.wanted() ? compare_labels : compare_scan;
    ScanReport report = compare(arguments, scan, outputs.page.stem().string(), no_pictures);
    for (const auto& [name, picture] : report.pictures)
        write_text(outputs.page.parent_path() / name, picture);
    write_text(outputs.beside(".json"), report.json);
    write_text(outputs.beside(".csv"), report.csv);
    write_text(outputs.beside(".md"), report.markdown);
    write_text(outputs.page, report.page);
    if (!arguments.quiet)
        std::cout << report.headline << "\n\n"
                  << report.table << "\nwritten " << outputs.page.string() << std::endl;
    return report;
}

void check_arguments(const CompareArguments& arguments, const Scans& scans)
{
    if (arguments.output.empty())
        throw UsageError("--output is required (see voroprobe compare --help)");
    for (const fs::path& scan : scans.paths)
    {
        check_request({.path = scan, .read = arguments.read});
        check_compared_labels(arguments, scan);
    }
    const bool is_page = arguments.output.extension() == ".html";
    if (!scans.into_folder && !is_page)
        throw UsageError("--output is '" + arguments.output.string() +
                         "'; allowed with one scan: a name that ends in .html");
    if (scans.into_folder && is_page)
        throw UsageError("--output is '" + arguments.output.string() +
                         "'; allowed with several scans: a folder, for a page each");
    if (scans.into_folder && !arguments.with.empty())
        throw UsageError("--with is '" + arguments.with.front().name + "=" +
                         arguments.with.front().path.string() + "'; allowed: only with one scan");
    check_files(arguments, scans);
}

void make_folder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw OutputError("cannot write '" + folder.string() + "': " + error.message());
}

//! One page after the other, and an index of those there are. A scan that cannot be read is told of, and the
//! others come.
void compare_all(const CompareArguments& arguments, const Scans& scans,
                 const std::optional<std::string>& no_pictures)
{
    make_folder(arguments.output);
    check_writable(arguments.output / "index.html");
    std::vector<std::pair<std::string, std::string>> pages;
    std::vector<std::string> failures;
    for (const fs::path& scan : scans.paths)
    {
        const Outputs outputs = outputs_of(arguments, scans, scan);
        try
        {
            pages.emplace_back(outputs.page.filename().string(),
                               compare_into(outputs, arguments, scan, no_pictures).json);
        }
        catch (const Error& error)
        {
            const std::string reason = error.what();
            failures.push_back(reason.starts_with(scan.string()) ? reason : scan.string() + ": " + reason);
        }
    }
    if (!pages.empty())
        write_text(arguments.output / "index.html", report_index(pages));
    print_warnings(failures);
    if (!failures.empty())
        throw InputError(std::to_string(failures.size()) + " of " + std::to_string(scans.paths.size()) +
                         " scans have no page: " + failures.front());
}

} // namespace

void run_compare_command(const CompareArguments& arguments)
{
    const Scans scans = scans_of(arguments.inputs);
    check_arguments(arguments, scans);
    const OneThread one_thread; // contestants are forks of this process
    std::optional<VirtualDisplay> display;
    if (arguments.pictures)
        display.emplace();
    const std::optional<std::string> no_pictures = display ? display->failure() : std::nullopt;
    if (no_pictures)
        print_warnings({"no pictures: " + *no_pictures});
    if (scans.into_folder)
        return compare_all(arguments, scans, no_pictures);
    check_writable(arguments.output);
    compare_into({arguments.output}, arguments, scans.paths.front(), no_pictures);
}

} // namespace voroprobe
