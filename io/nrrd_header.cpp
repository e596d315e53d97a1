#include "io/nrrd_header.h"

#include <algorithm>
#include <sstream>

#include "io/volume_bytes.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

//! Headers end with an empty line; even segmentations of a thousand segments are shorter.
constexpr std::size_t kMaxHeaderBytes = 1U << 22U;

constexpr std::string_view kMarkOfSegmentation = "Segmentation_";

} // namespace

std::vector<std::string> nrrd_header_lines(const std::filesystem::path& path)
{
    std::istringstream head(read_head(path, kMaxHeaderBytes));
    std::vector<std::string> lines;
    for (std::string line; std::getline(head, line);)
    {
        if (!line.empty() && line.back() == '\r')
            line.pop_back();
        if (line.empty())
            break;
        lines.push_back(line);
    }
    if (lines.empty() || !lines.front().starts_with("NRRD"))
        throw InputError("is not a NRRD file: expected it to begin with \"NRRD\"");
    return lines;
}

std::string nrrd_field(const std::vector<std::string>& lines, const std::string& name)
{
    for (const std::string& line : lines)
        if (line.starts_with(name + ':'))
        {
            const std::size_t begin = name.size() + 1;
            return line.substr(line.compare(begin, 1, "=") == 0 ? begin + 1 : begin);
        }
    return {};
}

bool is_segmentation(const std::vector<std::string>& lines)
{
    return std::any_of(lines.begin(), lines.end(),
                       [](const std::string& line)
                       { return line.starts_with(kMarkOfSegmentation) || line.starts_with("Segment0_"); });
}

} // namespace voroprobe
