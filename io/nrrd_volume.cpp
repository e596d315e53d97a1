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
#include "io/nrrd_header.h"
#include "io/volume_bytes.h"
#include "io/volume_formats.h"
#include "io/volume_itk.h"
#include "support/error.h"
#include "support/text.h"

namespace voroprobe
{

namespace
{

//! False also where the spacing along an axis of space is "nan", which stands for unknown.
bool gives_spacing(const std::vector<std::string>& lines)
{
    if (!nrrd_field(lines, "space directions").empty())
        return true;
    std::istringstream words(nrrd_field(lines, "spacings"));
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
    const bool in_space = !nrrd_field(lines, "space directions").empty();
    std::vector<std::string> units = quoted_words(nrrd_field(lines, in_space ? "space units" : "units"));
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
    const std::string sizes = nrrd_field(lines, "sizes");
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

//! Refuses what 3D Slicer writes for a segmentation without segments: an image of one voxel.
void require_a_segment(const std::vector<std::string>& lines, const itk::ImageIOBase& image_io)
{
    if (is_segmentation(lines) && image_io.GetImageSizeInPixels() == 1)
        throw InputError(
            "holds no segments: its one voxel stands for no data, expected a segmentation that is "
            "not empty");
}

} // namespace

StoredVolume read_nrrd(const std::filesystem::path& path, const ReadOptions& options)
{
    const std::vector<std::string> lines = nrrd_header_lines(path);
    require_sizes(lines);
    const auto image_io = itk::NrrdImageIO::New();
    read_itk_header(*image_io, path);

    StoredVolume volume{.lattice = itk_lattice(*image_io), .format = "NRRD"};
    const bool has_layers = is_segmentation(lines) && image_io->GetNumberOfComponents() > 1;
    require_a_segment(lines, *image_io);
    volume.stored_type =
        stored_type_name(has_layers ? itk_component_type(*image_io) : itk_stored_type(*image_io));
    volume.has_spacing = gives_spacing(lines);
    if (!options.spacing)
        volume.warnings = unit_warnings(lines);
    if (image_io->GetImageSizeInBytes() > 0)
        require_plausible_length(path, lines, *image_io);
    volume.samples = has_layers ? read_itk_component(*image_io, options.frame, volume.warnings)
                                : read_itk_samples(*image_io, options.frame, volume.warnings);
    return volume;
}

} // namespace voroprobe
