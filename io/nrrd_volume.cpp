// The format: teem.sourceforge.net/nrrd/format.html. ITK's reader checks lengths and reports errors itself.

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include <itkNrrdImageIO.h>

#include "io/mesh_file.h"
#include "io/volume_bytes.h"
#include "io/volume_formats.h"
#include "io/volume_itk.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

//! Headers end with an empty line; ones longer than this do not occur.
constexpr std::size_t kMaxHeaderBytes = 1U << 16U;

//! Fields of the header as "name: value" lines.
std::vector<std::string> header_lines(const std::filesystem::path& path)
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

std::string trimmed(const std::string& text)
{
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

//! What follows "name:"; empty where the field is missing.
std::string field(const std::vector<std::string>& lines, const std::string& name)
{
    for (const std::string& line : lines)
        if (line.starts_with(name + ':'))
            return line.substr(name.size() + 1);
    return {};
}

//! False also where the spacing along an axis of space is "nan", which stands for unknown.
bool gives_spacing(const std::vector<std::string>& lines)
{
    if (!field(lines, "space directions").empty())
        return true;
    std::istringstream words(field(lines, "spacings"));
    std::size_t known = 0;
    for (std::string word; known < 3 && words >> word; ++known)
        if (!std::isfinite(std::strtod(word.c_str(), nullptr)))
            return false;
    return known > 0;
}

//! The words in quotes: "mm" "mm" "s".
std::vector<std::string> quoted_words(const std::string& text)
{
    std::vector<std::string> words;
    std::istringstream quoted(text);
    for (std::string word; std::getline(quoted, word, '"') && std::getline(quoted, word, '"');)
        words.push_back(word);
    return words;
}

//! Of units of the axes of space other than mm; none where they are unknown. Where the file lies in a space,
//! its axes have those of the space; otherwise, each has its own.
std::vector<std::string> unit_warnings(const std::vector<std::string>& lines)
{
    constexpr std::array<std::string_view, 7> kNoOther{
        "", "???", "mm", "millimeter", "millimeters", "millimetre", "millimetres"};
    const bool in_space = !field(lines, "space directions").empty();
    std::vector<std::string> units = quoted_words(field(lines, in_space ? "space units" : "units"));
    units.resize(std::min<std::size_t>(units.size(), 3)); // a fourth axis is of time or of frames
    for (const std::string& unit : units)
        if (std::find(kNoOther.begin(), kNoOther.end(), unit) == kNoOther.end())
            return {"the header gives the " + std::string(in_space ? "space unit " : "unit ") +
                    in_quotes(unit) + ": its lengths are taken for mm, --spacing x,y,z sets the voxel size"};
    return {};
}

//! Refuses sizes that are no whole numbers from 1 on, or whose product is beyond all memory.
void require_sizes(const std::vector<std::string>& lines)
{
    const std::string sizes = field(lines, "sizes");
    std::istringstream words(sizes);
    std::int64_t samples = 1;
    bool fits = true;
    for (std::string word; words >> word;)
    {
        const auto size = parse_number<std::int64_t>(word);
        const bool too_large = word.find_first_not_of("0123456789") == std::string::npos && !size;
        if (!too_large && size.value_or(0) < 1)
            throw InputError("the header gives the size " + in_quotes(word) +
                             ", expected whole numbers of at least 1");
        fits = fits && !too_large && !__builtin_mul_overflow(samples, *size, &samples);
    }
    if (!fits)
        throw InputError("the header gives the sizes " + in_quotes(trimmed(sizes)) +
                         ", more samples than any memory holds, expected fewer than 2^63");
}

//! Refuses an attached header without enough bytes behind it for its samples, whatever the encoding, before
//! allocating.
void require_plausible_length(const std::filesystem::path& path, const std::vector<std::string>& lines,
                              const itk::ImageIOBase& image_io)
{
    std::string encoding;
    for (const std::string& line : lines)
    {
        if (line.starts_with("data file:") || line.starts_with("datafile:"))
            return;
        if (line.starts_with("encoding:"))
            encoding = line.substr(line.find_first_not_of(' ', line.find(':') + 1));
    }
    ByteSource source{.files = {path}};
    if (encoding == "gzip" || encoding == "gz" || encoding == "bzip2" || encoding == "bz2")
        source.packing = Packing::kZlib;
    else if (encoding != "raw")
        return;
    require_bytes(source, static_cast<std::uint64_t>(image_io.GetImageSizeInBytes()));
}

} // namespace

StoredVolume read_nrrd(const std::filesystem::path& path, const ReadOptions& options)
{
    const std::vector<std::string> lines = header_lines(path);
    require_sizes(lines);
    const auto image_io = itk::NrrdImageIO::New();
    read_itk_header(*image_io, path);

    StoredVolume volume{.lattice = itk_lattice(*image_io), .format = "NRRD"};
    volume.stored_type = stored_type_name(itk_stored_type(*image_io));
    volume.has_spacing = gives_spacing(lines);
    if (!options.spacing)
        volume.warnings = unit_warnings(lines);
    if (image_io->GetImageSizeInBytes() > 0)
        require_plausible_length(path, lines, *image_io);
    volume.samples = read_itk_samples(*image_io, options.frame, volume.warnings);
    return volume;
}

} // namespace voroprobe
