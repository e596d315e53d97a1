// The formats: itksnap.org (label descriptions),
// surfer.nmr.mgh.harvard.edu/fswiki/LabelsClutsAnnotationFiles, slicer.readthedocs.io (colour tables).

#include "io/label_table.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "io/mesh_file.h"
#include "support/error.h"
#include "support/text.h"
#include "support/utf8.h"

namespace voroprobe
{
namespace
{

constexpr std::string_view kBlanks = " \t\r";

std::vector<std::string_view> words_of(std::string_view text)
{
    std::vector<std::string_view> words;
    for (text = trimmed(text); !text.empty(); text = trimmed(text))
    {
        const std::size_t end = std::min(text.find_first_of(kBlanks), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return words;
}

//! The numbers of 0 to 255 that words[first] to words[first + 2] are.
std::optional<Color> color_of(const std::vector<std::string_view>& words, std::size_t first)
{
    Color color;
    for (std::uint8_t* channel : {&color.red, &color.green, &color.blue})
    {
        const auto value = parse_number<int>(words[first++]);
        if (!value || *value < 0 || *value > 255)
            return std::nullopt;
        *channel = static_cast<std::uint8_t>(*value);
    }
    return color;
}

//! A line of ITK-SNAP: seven numbers and a name in quotes.
std::optional<LabelEntry> snap_entry(std::string_view line)
{
    constexpr std::size_t kNumbers = 7;
    const std::size_t open = line.find('"');
    const std::size_t close = line.rfind('"');
    if (open == std::string_view::npos || close == open || !trimmed(line.substr(close + 1)).empty())
        return std::nullopt;
    const auto words = words_of(line.substr(0, open));
    if (words.size() != kNumbers)
        return std::nullopt;
    const auto value = parse_number<std::int64_t>(words[0]);
    const auto color = color_of(words, 1);
    if (!value || !color)
        return std::nullopt;
    return LabelEntry{*value, std::string(trimmed(line.substr(open + 1, close - open - 1))), color};
}

//! A line of FreeSurfer or Slicer: number, name, and four numbers behind it.
std::optional<LabelEntry> lut_entry(std::string_view line)
{
    constexpr std::size_t kBehindName = 4;
    const auto words = words_of(line);
    if (words.size() < 2 + kBehindName || !parse_number<double>(words.back()))
        return std::nullopt;
    const auto value = parse_number<std::int64_t>(words[0]);
    const auto color = color_of(words, words.size() - kBehindName);
    if (!value || !color)
        return std::nullopt;
    const char* name_end =
        words[words.size() - kBehindName - 1].data() + words[words.size() - kBehindName - 1].size();
    return LabelEntry{*value, {words[1].data(), name_end}, color};
}

std::optional<LabelEntry> plain_entry(std::string_view line)
{
    const std::size_t end = std::min(line.find_first_of(" \t\r,;:="), line.size());
    const auto value = parse_number<std::int64_t>(line.substr(0, end));
    if (!value)
        return std::nullopt;
    std::string_view name = trimmed(line.substr(end));
    if (!name.empty() && std::string_view(",;:=").find(name.front()) != std::string_view::npos)
        name = trimmed(name.substr(1));
    if (name.size() >= 2 && name.front() == '"' && name.back() == '"')
        name = name.substr(1, name.size() - 2);
    return LabelEntry{*value, std::string(name)};
}

std::optional<LabelEntry> entry_of(std::string_view line)
{
    if (auto entry = snap_entry(line))
        return entry;
    if (auto entry = lut_entry(line))
        return entry;
    return plain_entry(line);
}

} // namespace

std::vector<LabelEntry> read_label_table(const std::filesystem::path& path)
{
    std::error_code unknown; // then it is no file
    if (!std::filesystem::is_regular_file(path, unknown))
        fail_reading(path, "there is no such file");
    std::istringstream lines(as_utf8(read_whole_file(path)));
    std::vector<LabelEntry> entries;
    std::map<std::int64_t, std::string> name_of;
    std::size_t number = 0;
    for (std::string text; std::getline(lines, text);)
    {
        ++number;
        const std::string_view line = trimmed(text);
        if (line.empty() || line.starts_with('#') || line.starts_with("//"))
            continue;
        const auto entry = entry_of(line);
        if (!entry)
            fail_reading(path, "line " + std::to_string(number) + " begins with " +
                                   in_quotes(words_of(line)[0]) + ", expected a label's number and its name");
        const auto [known, is_new] = name_of.emplace(entry->value, entry->name);
        if (!is_new && known->second != entry->name)
            fail_reading(path, "line " + std::to_string(number) + " names label " +
                                   std::to_string(entry->value) + ' ' + in_quotes(entry->name) +
                                   ", which was " + in_quotes(known->second) +
                                   " before; expected one name for each");
        if (is_new)
            entries.push_back(*entry);
    }
    return entries;
}

} // namespace voroprobe
