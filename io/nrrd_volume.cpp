// The format: teem.sourceforge.net/nrrd/format.html. ITK's reader checks lengths and reports errors itself.

#include <algorithm>
#include <cctype>
#include <sstream>

#include <itkNrrdImageIO.h>

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

bool gives_spacing(const std::vector<std::string>& lines)
{
    return std::any_of(lines.begin(), lines.end(),
                       [](const std::string& line)
                       { return line.starts_with("spacings:") || line.starts_with("space directions:"); });
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
    const auto image_io = itk::NrrdImageIO::New();
    read_itk_header(*image_io, path);

    StoredVolume volume{.lattice = itk_lattice(*image_io), .format = "NRRD"};
    volume.stored_type = stored_type_name(itk_stored_type(*image_io));
    volume.has_spacing = gives_spacing(lines);
    if (image_io->GetImageSizeInBytes() > 0)
        require_plausible_length(path, lines, *image_io);
    volume.samples = read_itk_samples(*image_io, options.frame);
    return volume;
}

} // namespace voroprobe
