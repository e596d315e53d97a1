// The keys: 3D Slicer, Libs/vtkSegmentationCore and its documentation of .seg.nrrd files.

#include "io/nrrd_segments.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "io/mesh_file.h"
#include "io/nrrd_header.h"
#include "io/volume_bytes.h"
#include "support/error.h"
#include "support/text.h"
#include "support/utf8.h"

namespace voroprobe
{
namespace
{

template <class Number>
Number number_or(const std::vector<std::string>& lines, const std::string& key, Number otherwise,
                 const std::filesystem::path& path)
{
    const std::string field = nrrd_field(lines, key);
    const std::string_view text = trimmed(field);
    if (text.empty())
        return otherwise;
    const auto number = parse_number<Number>(text);
    if (!number)
        fail_reading(path, key + " is " + in_quotes(text) + ", expected a whole number");
    return *number;
}

//! Three fractions of 1, "0.5 0.2 1".
std::optional<Color> color_of(const std::string& text)
{
    constexpr double kBrightest = 255.0;
    std::istringstream words(text);
    Color color;
    for (std::uint8_t* channel : {&color.red, &color.green, &color.blue})
    {
        std::string word;
        words >> word;
        const auto share = parse_number<double>(word);
        if (!share || !(*share >= 0.0 && *share <= 1.0))
            return std::nullopt;
        *channel = static_cast<std::uint8_t>(std::lround(kBrightest * *share));
    }
    return color;
}

bool begins_as_nrrd(const std::filesystem::path& path)
{
    std::error_code unknown; // then it is no file
    return std::filesystem::is_regular_file(path, unknown) && std::filesystem::file_size(path, unknown) > 0 &&
           read_head(path, 4) == "NRRD";
}

} // namespace

std::vector<Segment> read_segments(const std::filesystem::path& path)
{
    if (!begins_as_nrrd(path))
        return {};
    const std::vector<std::string> lines = nrrd_header_lines(path);
    std::vector<Segment> segments;
    for (std::int64_t n = 0;; ++n)
    {
        const std::string key = "Segment" + std::to_string(n) + '_';
        if (std::none_of(lines.begin(), lines.end(),
                         [&](const std::string& line) { return line.starts_with(key); }))
            return segments;
        Segment segment{.entry = {.value = number_or<std::int64_t>(lines, key + "LabelValue", 1, path),
                                  .name = as_utf8(std::string(trimmed(nrrd_field(lines, key + "Name")))),
                                  .color = color_of(nrrd_field(lines, key + "Color"))}};
        segment.layer = number_or<std::size_t>(lines, key + "Layer", static_cast<std::size_t>(n), path);
        segments.push_back(std::move(segment));
    }
}

} // namespace voroprobe
