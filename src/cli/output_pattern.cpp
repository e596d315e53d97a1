#include "cli/output_pattern.h"

#include <map>
#include <system_error>

#include "support/error.h"
#include "support/text.h"

namespace voroprobe
{
namespace
{

constexpr std::string_view kLabel = "{label}";
constexpr std::string_view kName = "{name}";

//! Fit for a file name on every system, and no hidden file.
std::string for_file_name(const std::string& name)
{
    constexpr std::string_view kForbidden = "/\\:*?\"<>|";
    std::string fit;
    for (const char c : name)
        fit += static_cast<unsigned char>(c) < ' ' || kForbidden.find(c) != std::string_view::npos ? '_' : c;
    if (fit.empty() || fit.front() == '.')
        fit.insert(fit.begin(), '_');
    return fit;
}

std::string replaced(std::string text, std::string_view from, const std::string& to)
{
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

void refuse_other_braces(const std::string& pattern)
{
    const std::string rest = replaced(replaced(pattern, kLabel, ""), kName, "");
    if (const std::size_t open = rest.find('{'); open != std::string::npos)
        throw UsageError("--output is '" + pattern + "', with '" +
                         rest.substr(open, rest.find('}', open) - open + 1) +
                         "'; allowed: {label} and {name}");
}

} // namespace

bool is_output_pattern(const std::filesystem::path& path)
{
    return path.string().find('{') != std::string::npos;
}

std::vector<std::filesystem::path> expand_pattern(const std::filesystem::path& pattern,
                                                  std::span<const PatternValues> values)
{
    refuse_other_braces(pattern.string());
    std::vector<std::filesystem::path> paths;
    std::map<std::string, std::string> label_of; // of paths, whatever the case of their letters
    for (const PatternValues& value : values)
    {
        const std::string path =
            replaced(replaced(pattern.string(), kLabel, value.label), kName, for_file_name(value.name));
        const auto [known, is_new] = label_of.emplace(lower_case(path), value.label);
        if (!is_new)
            throw UsageError("--output '" + pattern.string() + "' gives '" + path + "' for label " +
                             known->second + " and for label " + value.label +
                             ": one would overwrite the other; allowed: a pattern that tells them apart by "
                             "{label} and {name}");
        paths.emplace_back(path);
    }
    return paths;
}

void make_folder_of(const std::filesystem::path& path)
{
    const std::filesystem::path folder = path.parent_path();
    std::error_code error;
    if (!folder.empty() && !std::filesystem::exists(folder))
        std::filesystem::create_directories(folder, error);
    if (error)
        throw OutputError("cannot make the folder '" + folder.string() + "': " + error.message());
}

} // namespace voroprobe
