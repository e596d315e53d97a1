// The format: itk.org/Wiki/ITK/MetaIO/Documentation.
//
// ITK decides where the samples are. They are read here, because ITK's reader returns zeros for what a
// truncated file lacks and leaves the intensity function of the header aside.

#include <algorithm>
#include <cstdio>
#include <map>
#include <sstream>

#include <itkMetaImageIO.h>

#include "io/volume_bytes.h"
#include "io/volume_formats.h"
#include "io/volume_itk.h"
#include "support/error.h"
#include "support/text.h"

namespace voroprobe
{

namespace
{

//! A header that lists one file for each of thousands of slices fits.
constexpr std::size_t kMaxHeaderBytes = 1U << 22U;

struct Header
{
    std::map<std::string, std::string> fields;
    std::vector<std::string> lines_after; //!< file names where ElementDataFile is LIST
    std::size_t byte_count = 0;           //!< where the samples of a LOCAL file start

    [[nodiscard]] std::string text(const std::string& name, const std::string& otherwise) const
    {
        const auto found = fields.find(name);
        return found == fields.end() ? otherwise : found->second;
    }
    [[nodiscard]] const std::string& required(const std::string& name) const
    {
        const auto found = fields.find(name);
        if (found == fields.end())
            throw InputError("is not a MetaImage header: lacks " + name);
        return found->second;
    }
    [[nodiscard]] bool is_true(const std::string& name, bool otherwise) const
    {
        const auto found = fields.find(name);
        return found == fields.end() ? otherwise
                                     : found->second.starts_with('T') || found->second.starts_with('t');
    }
};

Header read_header(const std::filesystem::path& path)
{
    Header header;
    std::istringstream head(read_head(path, kMaxHeaderBytes));
    for (std::string line; std::getline(head, line);)
    {
        const std::size_t equals = line.find('=');
        if (header.fields.contains("ElementDataFile"))
            header.lines_after.emplace_back(trimmed(line));
        else if (equals == std::string::npos)
            break;
        else
        {
            const std::string_view field = line;
            header.fields[std::string(trimmed(field.substr(0, equals)))] = trimmed(field.substr(equals + 1));
        }
        if (header.text("ElementDataFile", "") == "LOCAL")
        {
            header.byte_count = static_cast<std::size_t>(head.tellg());
            break;
        }
    }
    for (const char* name : {"NDims", "DimSize", "ElementType", "ElementDataFile"})
        static_cast<void>(header.required(name));
    return header;
}

//! All numbers of a field. \throw InputError where something else stands there, or one that is not finite.
std::vector<double> numbers(const Header& header, const std::string& name)
{
    std::istringstream words(header.required(name));
    std::vector<double> values;
    for (std::string word; words >> word;)
    {
        std::istringstream stream(word);
        double value = 0.0;
        if (!(stream >> value) || stream.peek() != std::istringstream::traits_type::eof())
            throw InputError("the header gives " + name + " = " + header.required(name) +
                             ", expected finite numbers");
        values.push_back(value);
    }
    if (values.empty())
        throw InputError("the header gives no value for " + name + ", expected finite numbers");
    return values;
}

double number(const Header& header, const std::string& name, double otherwise)
{
    return header.fields.contains(name) ? numbers(header, name).front() : otherwise;
}

//! Sizes along the three axes of space and, last, the number of volumes.
std::array<std::int64_t, 4> dimensions(const Header& header)
{
    const std::vector<double> values = numbers(header, "DimSize");
    if (number(header, "NDims", 0.0) != static_cast<double>(values.size()) || values.size() < 2 ||
        values.size() > 10)
        throw InputError("the header gives NDims = " + header.required("NDims") + " and DimSize = " +
                         header.required("DimSize") + ", expected 3 dimensions and as many sizes");
    std::array<std::int64_t, 4> size{1, 1, 1, 1};
    for (std::size_t axis = 0; axis < values.size(); ++axis)
    {
        constexpr double kMaxSize = 1e9;
        if (!(values[axis] >= 1.0 && values[axis] <= kMaxSize))
            throw InputError("the header gives DimSize = " + header.required("DimSize") +
                             ", expected numbers from 1 to 1000000000");
        const auto n = static_cast<std::int64_t>(values[axis]);
        std::int64_t& product = size[std::min<std::size_t>(axis, 3)];
        if (__builtin_mul_overflow(product, n, &product))
            throw InputError("the header gives DimSize = " + header.required("DimSize") +
                             ", more than fits in memory");
    }
    return size;
}

//! Refuses fields that MetaIO reads and that are no finite numbers or not as many as there are dimensions:
//! it prints about some of them by itself and takes others for something else.
void require_numbers(const Header& header)
{
    const std::size_t axes = numbers(header, "DimSize").size();
    const auto require = [&](const char* name, std::size_t count)
    {
        if (header.fields.contains(name) && numbers(header, name).size() != count)
            throw InputError("the header gives " + std::string(name) + " = " + header.required(name) +
                             ", expected " + std::to_string(count) + " numbers");
    };
    for (const char* name :
         {"ElementSpacing", "ElementSize", "Offset", "Position", "Origin", "CenterOfRotation"})
        require(name, axes);
    for (const char* name : {"TransformMatrix", "Rotation", "Orientation"})
        require(name, axes * axes);
    for (const char* name : {"ElementMin", "ElementMax"})
        require(name, 1);
}

SampleEncoding encoding(const Header& header)
{
    static const std::map<std::string, StoredType> kTypes{
        {"MET_UCHAR", StoredType::kUint8},    {"MET_CHAR", StoredType::kInt8},
        {"MET_USHORT", StoredType::kUint16},  {"MET_SHORT", StoredType::kInt16},
        {"MET_UINT", StoredType::kUint32},    {"MET_INT", StoredType::kInt32},
        {"MET_ULONG", StoredType::kUint32},   {"MET_LONG", StoredType::kInt32},
        {"MET_FLOAT", StoredType::kFloat32},  {"MET_ULONG_LONG", StoredType::kUint64},
        {"MET_DOUBLE", StoredType::kFloat64}, {"MET_LONG_LONG", StoredType::kInt64}};
    const auto type = kTypes.find(header.required("ElementType"));
    if (type == kTypes.end())
        throw InputError("the header gives ElementType = " + header.required("ElementType") +
                         ", expected one number of 8 to 64 bits, such as MET_SHORT");
    if (const double channels = number(header, "ElementNumberOfChannels", 1.0); channels != 1.0)
        throw InputError("has " + header.required("ElementNumberOfChannels") +
                         " values in each sample (a vector or color image), expected one");
    if (!header.is_true("BinaryData", true))
        throw InputError("holds its samples as text (BinaryData = False), expected binary samples");

    SampleEncoding encoding{.type = type->second};
    const bool native_is_big = std::endian::native == std::endian::big;
    const bool is_big =
        header.is_true("BinaryDataByteOrderMSB", header.is_true("ElementByteOrderMSB", native_is_big));
    encoding.order = is_big ? std::endian::big : std::endian::little;
    encoding.slope = number(header, "ElementToIntensityFunctionSlope", 1.0);
    encoding.intercept = number(header, "ElementToIntensityFunctionOffset", 0.0);
    return encoding;
}

//! File names of "slice%03d.raw 1 20 1".
std::vector<std::string> expand_pattern(const std::string& text)
{
    std::istringstream stream(text);
    std::string pattern;
    long first = 0;
    long last = 0;
    long step = 1;
    stream >> pattern >> first >> last >> step;
    const std::size_t percent = pattern.find('%');
    const std::size_t end = pattern.find('d', percent);
    const std::string digits = pattern.substr(percent + 1, end - percent - 1);
    constexpr long kMaxFiles = 1'000'000;
    if (end == std::string::npos || digits.find_first_not_of("0123456789") != std::string::npos ||
        digits.size() > 2 || step < 1 || last < first || last - first > kMaxFiles)
        throw InputError("the header gives ElementDataFile = " + text +
                         ", expected a pattern like slice%03d.raw 1 20 1");

    const std::size_t width = digits.empty() ? 0 : std::stoul(digits);
    std::vector<std::string> names;
    for (long number = first; number <= last; number += step)
    {
        std::string middle = std::to_string(number);
        middle.insert(0, width > middle.size() ? width - middle.size() : 0,
                      digits.starts_with('0') ? '0' : ' ');
        names.push_back(pattern.substr(0, percent) + middle + pattern.substr(end + 1));
    }
    return names;
}

std::vector<std::filesystem::path> data_files(const std::filesystem::path& path, const Header& header)
{
    const std::string& value = header.required("ElementDataFile");
    if (value == "LOCAL")
        return {path};
    std::vector<std::string> names{value};
    if (value.starts_with("LIST"))
    {
        names = header.lines_after;
        std::erase(names, "");
    }
    else if (value.find('%') != std::string::npos)
        names = expand_pattern(value);
    std::vector<std::filesystem::path> files;
    for (const std::string& name : names)
        files.push_back(path.parent_path() / name);
    if (files.empty())
        throw InputError("the header lists no data file");
    return files;
}

//! Keeps the files of one volume, or the part of the only file.
void choose_frame_part(ByteSource& source, std::size_t frame, std::size_t frame_count,
                       std::size_t frame_bytes)
{
    if (source.files.size() == 1)
    {
        source.skip = frame * frame_bytes;
        return;
    }
    const std::size_t files = source.files.size() / frame_count;
    if (files * frame_count != source.files.size() || frame_bytes % files != 0)
        throw InputError("the header lists " + std::to_string(source.files.size()) +
                         " data files, which do not divide the samples evenly");
    const auto first = source.files.begin() + static_cast<std::ptrdiff_t>(frame * files);
    source.files = std::vector(first, first + static_cast<std::ptrdiff_t>(files));
}

ByteSource sample_source(const std::filesystem::path& path, const Header& header, std::size_t part_bytes)
{
    ByteSource source{.files = data_files(path, header), .offset = header.byte_count};
    if (header.is_true("CompressedData", false))
        source.packing = Packing::kZlib;
    const double header_size = number(header, "HeaderSize", 0.0);
    if (header.required("ElementDataFile") == "LOCAL" || header_size == 0.0)
        return source;
    std::error_code error;
    const std::uint64_t file_bytes = std::filesystem::file_size(source.files.front(), error);
    if (header_size > 0.0)
        source.offset = static_cast<std::uint64_t>(header_size);
    else if (!error && file_bytes > part_bytes) // -1: the samples are the last bytes of the file
        source.offset = file_bytes - part_bytes;
    return source;
}

} // namespace

StoredVolume read_meta_image(const std::filesystem::path& path, const ReadOptions& options)
{
    const Header header = read_header(path);
    const SampleEncoding sample_encoding = encoding(header);
    const std::array<std::int64_t, 4> size = dimensions(header);
    require_numbers(header);
    const std::size_t sample_bytes = byte_size(sample_encoding.type);
    const std::size_t count = require_sane_size(std::span(size).first(3), sample_bytes);
    const std::size_t total = require_sane_size(size, sample_bytes);
    const auto frame_count = static_cast<std::size_t>(size[3]);
    const std::size_t frame = choose_frame(frame_count, options.frame);

    const std::size_t file_count = data_files(path, header).size();
    ByteSource source = sample_source(path, header, total * sample_bytes / file_count);
    choose_frame_part(source, frame, frame_count, count * sample_bytes);
    require_bytes(source, count * sample_bytes);

    const auto image_io = itk::MetaImageIO::New();
    read_itk_header(*image_io, path);
    StoredVolume volume{.lattice = itk_lattice(*image_io), .format = "MetaImage"};
    volume.stored_type = stored_type_name(sample_encoding.type);
    volume.has_spacing = header.fields.contains("ElementSpacing") || header.fields.contains("ElementSize");
    volume.samples = decode_samples(
        sample_encoding, count, [&](std::span<std::byte> to) { read_bytes(source, to); }, volume.warnings);
    return volume;
}

} // namespace voroprobe
