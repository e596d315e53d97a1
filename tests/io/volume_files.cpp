#include "volume_files.h"

#include <map>
#include <sstream>

#include <zlib.h>

namespace voroprobe
{

namespace
{

std::string deflated(const std::string& content, int window_bits)
{
    z_stream stream{};
    deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, content.size()) + 64, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<unsigned>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<unsigned>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

void put(std::string& bytes, std::size_t offset, const std::string& what)
{
    std::copy(what.begin(), what.end(), bytes.begin() + static_cast<std::ptrdiff_t>(offset));
}

std::string decimal(double value)
{
    std::ostringstream text;
    text.precision(10);
    text << value;
    return text.str();
}

template <class Numbers>
std::string joined(const Numbers& numbers)
{
    std::string text;
    for (const double number : numbers)
    {
        if (!text.empty())
            text += '\\';
        text += decimal(number);
    }
    return text;
}

//! A data element in explicit little endian; values have even length.
std::string element(std::uint16_t group, std::uint16_t number, const std::string& type, std::string value)
{
    if (value.size() % 2 != 0)
        value += type == "UI" ? '\0' : ' ';
    const std::string head = to_bytes(group, kLittle) + to_bytes(number, kLittle) + type;
    if (type == "OW" || type == "OB")
        return head + std::string(2, '\0') + to_bytes(static_cast<std::uint32_t>(value.size()), kLittle) +
               value;
    return head + to_bytes(static_cast<std::uint16_t>(value.size()), kLittle) + value;
}

std::string short_element(std::uint16_t group, std::uint16_t number, std::uint16_t value)
{
    return element(group, number, "US", to_bytes(value, kLittle));
}

} // namespace

std::string gzip_of(const std::string& content)
{
    return deflated(content, 16 + MAX_WBITS);
}

std::string zlib_of(const std::string& content)
{
    return deflated(content, MAX_WBITS);
}

std::string gunzip_of(const std::string& packed)
{
    z_stream stream{};
    inflateInit2(&stream, 16 + MAX_WBITS);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<unsigned>(packed.size());
    std::string content;
    std::string chunk(1U << 20U, '\0');
    int status = Z_OK;
    while (status == Z_OK)
    {
        stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
        stream.avail_out = static_cast<unsigned>(chunk.size());
        status = inflate(&stream, Z_NO_FLUSH);
        content.append(chunk, 0, chunk.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    return content;
}

std::string lines(const std::vector<std::string>& text)
{
    std::string all;
    for (const std::string& line : text)
        all += line + "\n";
    return all;
}

std::string nifti_of(const NiftiHeader& header, const std::string& samples)
{
    static const std::map<int, int> kBits{{2, 8},    {4, 16},   {8, 32},    {16, 32},   {64, 64}, {256, 8},
                                          {512, 16}, {768, 32}, {1024, 64}, {1280, 64}, {128, 24}};
    const auto number = [&](auto value) { return to_bytes(value, header.order); };
    std::string bytes(352, '\0');
    put(bytes, 0, number(std::int32_t{348}));
    put(bytes, 40, number(static_cast<std::int16_t>(header.size.size())));
    for (std::size_t axis = 0; axis < 7; ++axis)
    {
        const bool given = axis < header.size.size();
        put(bytes, 42 + 2 * axis, number(given ? header.size[axis] : std::int16_t{1}));
        put(bytes, 80 + 4 * axis, number(axis < 3 ? header.spacing[axis] : 1.0F));
    }
    put(bytes, 70, number(header.datatype) + number(static_cast<std::int16_t>(kBits.at(header.datatype))));
    put(bytes, 76, number(1.0F));
    put(bytes, 108, number(352.0F) + number(header.slope) + number(header.intercept));
    bytes[123] = 2; // mm
    put(bytes, 252, number(std::int16_t{header.quaternion.empty() ? std::int16_t{0} : std::int16_t{1}}));
    put(bytes, 254, number(std::int16_t{header.sform.empty() ? std::int16_t{0} : std::int16_t{1}}));
    put(bytes, 256, to_bytes(header.quaternion, header.order));
    put(bytes, 280, to_bytes(header.sform, header.order));
    put(bytes, 344, "n+1");
    return bytes + samples;
}

std::string nrrd_of(const std::vector<std::string>& fields, const std::string& samples)
{
    return "NRRD0004\n" + lines(fields) + "\n" + samples;
}

std::string inrimage_of(const std::vector<std::string>& fields, const std::string& samples)
{
    std::string head = "#INRIMAGE-4#{\n" + lines(fields);
    const std::size_t blocks = (head.size() + 4 + 255) / 256;
    head.resize(blocks * 256 - 4, '\n');
    return head + "##}\n" + samples;
}

std::string vti_of(const std::string& extent, const std::string& array_attributes,
                   const std::string& image_attributes, const std::string& samples)
{
    return "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
           "<ImageData WholeExtent=\"" +
           extent + "\" " + image_attributes + ">\n<Piece Extent=\"" + extent +
           "\"><PointData><DataArray Name=\"values\" " + array_attributes +
           " format=\"appended\" offset=\"0\"/></PointData></Piece>\n</ImageData>\n"
           "<AppendedData encoding=\"raw\">\n_" +
           to_bytes(static_cast<std::uint64_t>(samples.size()), kLittle) + samples +
           "\n</AppendedData>\n</VTKFile>\n";
}

std::string tiff_of(const TiffPages& layout, const std::vector<std::string>& pages)
{
    const auto word = [&](std::size_t value)
    { return to_bytes(static_cast<std::uint16_t>(value), layout.order); };
    const auto dword = [&](std::size_t value)
    { return to_bytes(static_cast<std::uint32_t>(value), layout.order); };
    constexpr std::size_t kShort = 3;
    constexpr std::size_t kLong = 4;
    constexpr std::size_t kAscii = 2;
    std::string bytes = (layout.order == kLittle ? "II" : "MM") + word(42) + dword(0);
    std::size_t link = 4; // where the position of the next directory belongs
    for (const std::string& page : pages)
    {
        const std::size_t strip = bytes.size();
        bytes += page;
        const std::size_t text = bytes.size();
        bytes += layout.description + std::string(2 - layout.description.size() % 2, '\0');
        bytes.resize(bytes.size() + bytes.size() % 2, '\0');
        put(bytes, link, dword(bytes.size()));

        std::vector<std::string> entries;
        const auto entry = [&](std::size_t tag, std::size_t type, std::size_t count, std::size_t value)
        {
            entries.push_back(word(tag) + word(type) + dword(count) +
                              (type == kShort ? word(value) + word(0) : dword(value)));
        };
        entry(256, kLong, 1, layout.width);
        entry(257, kLong, 1, layout.height);
        entry(258, kShort, 1, layout.bits);
        entry(259, kShort, 1, 1);
        entry(262, kShort, 1, 1);
        if (layout.description.size() > 4)
            entry(270, kAscii, layout.description.size() + 1, text);
        entry(273, kLong, 1, strip);
        entry(277, kShort, 1, layout.samples_per_pixel);
        entry(278, kLong, 1, layout.height);
        entry(279, kLong, 1, page.size());
        entry(339, kShort, 1, layout.format);
        bytes += word(entries.size());
        for (const std::string& one : entries)
            bytes += one;
        link = bytes.size();
        bytes += dword(0);
    }
    return bytes;
}

std::string dicom_of(const DicomSlice& slice, const std::vector<std::int16_t>& samples)
{
    const std::string ct_image = "1.2.840.10008.5.1.4.1.1.2";
    const std::string instance_uid = slice.series + "." + std::to_string(slice.instance);
    const std::string meta = element(2, 1, "OB", std::string("\0\1", 2)) + element(2, 2, "UI", ct_image) +
                             element(2, 3, "UI", instance_uid) +
                             element(2, 0x10, "UI", "1.2.840.10008.1.2.1") + element(2, 0x12, "UI", "1.2.3");
    std::string bytes(128, '\0');
    bytes += "DICM";
    bytes += element(2, 0, "UL", to_bytes(static_cast<std::uint32_t>(meta.size()), kLittle)) + meta;
    bytes += element(8, 0x16, "UI", ct_image) + element(8, 0x18, "UI", instance_uid) +
             element(8, 0x60, "CS", "CT");
    bytes += element(0x20, 0xd, "UI", "1.2.3") + element(0x20, 0xe, "UI", slice.series);
    bytes += element(0x20, 0x13, "IS", std::to_string(slice.instance));
    bytes += element(0x20, 0x32, "DS", joined(slice.position)) +
             element(0x20, 0x37, "DS", joined(slice.orientation));
    bytes += short_element(0x28, 2, 1) + element(0x28, 4, "CS", "MONOCHROME2");
    bytes += short_element(0x28, 0x10, slice.rows) + short_element(0x28, 0x11, slice.columns);
    bytes += element(0x28, 0x30, "DS", joined(slice.pixel_spacing));
    bytes += short_element(0x28, 0x100, 16) + short_element(0x28, 0x101, 16) +
             short_element(0x28, 0x102, 15) + short_element(0x28, 0x103, 1);
    bytes += element(0x28, 0x1052, "DS", decimal(slice.intercept)) +
             element(0x28, 0x1053, "DS", decimal(slice.slope));
    return bytes + slice.further + element(0x7fe0, 0x10, "OW", to_bytes(samples, kLittle));
}

} // namespace voroprobe
