// The format: INRIA's INRIMAGE-4, as described at inrimage.gforge.inria.fr and written by CGAL's ImageIO and
// iso2mesh: a text header of a multiple of 256 bytes that ends with "##}", then the samples, x fastest.

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "io/volume_bytes.h"
#include "io/volume_formats.h"
#include "io/volume_samples.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

constexpr std::string_view kMagic = "#INRIMAGE-4#{";
constexpr std::string_view kHeaderEnd = "##}";
constexpr std::size_t kHeaderBlock = 256;
constexpr std::size_t kMaxHeaderBytes = 256 * kHeaderBlock;

struct Header
{
    std::map<std::string, std::string> fields;
    std::size_t byte_count; //!< where the samples start

    [[nodiscard]] const std::string* find(const std::string& name) const
    {
        const auto found = fields.find(name);
        return found == fields.end() ? nullptr : &found->second;
    }
};

Header read_header(const std::filesystem::path& path)
{
    const std::string head = read_head(path, kMaxHeaderBytes);
    if (!head.starts_with(kMagic))
        throw InputError("is not an Inrimage file: expected it to begin with \"#INRIMAGE-4#{\"");
    const std::size_t end = head.find(kHeaderEnd);
    if (end == std::string::npos)
        throw InputError("truncated: the header has no end, expected \"##}\"");

    const std::size_t blocks = (end + kHeaderEnd.size() + kHeaderBlock - 1) / kHeaderBlock;
    Header header{.fields = {}, .byte_count = blocks * kHeaderBlock};
    std::istringstream lines(head.substr(kMagic.size(), end - kMagic.size()));
    for (std::string line; std::getline(lines, line);)
    {
        if (!line.empty() && line.back() == '\r')
            line.pop_back();
        if (const std::size_t equals = line.find('='); equals != std::string::npos && line[0] != '#')
            header.fields[line.substr(0, equals)] = line.substr(equals + 1);
    }
    return header;
}

double number(const Header& header, const std::string& name, double otherwise)
{
    const std::string* text = header.find(name);
    if (text == nullptr)
        return otherwise;
    std::istringstream stream(*text);
    double value = 0.0;
    if (!(stream >> value))
        throw InputError("the header gives " + name + "=" + *text + ", expected a number");
    return value;
}

std::int64_t dimension(const Header& header, const std::string& name)
{
    constexpr double kMaxDimension = 9e15; // doubles are exact up to here
    const double value = number(header, name, 1.0);
    if (!(value >= 0.0 && value <= kMaxDimension) || value != std::floor(value))
        throw InputError("the header gives " + name + "=" + *header.find(name) +
                         ", expected a whole number above 0");
    return static_cast<std::int64_t>(value);
}

StoredType stored_type(const Header& header)
{
    const std::string* kind = header.find("TYPE");
    const std::string* size = header.find("PIXSIZE");
    if (kind == nullptr || size == nullptr)
        throw InputError("the header lacks TYPE or PIXSIZE");
    static const std::map<std::string, StoredType> kTypes{
        {"float 32", StoredType::kFloat32},         {"float 64", StoredType::kFloat64},
        {"signed fixed 8", StoredType::kInt8},      {"signed fixed 16", StoredType::kInt16},
        {"signed fixed 32", StoredType::kInt32},    {"signed fixed 64", StoredType::kInt64},
        {"unsigned fixed 8", StoredType::kUint8},   {"unsigned fixed 16", StoredType::kUint16},
        {"unsigned fixed 32", StoredType::kUint32}, {"unsigned fixed 64", StoredType::kUint64}};
    const std::string name = *kind + " " + size->substr(0, size->find(' '));
    if (const auto found = kTypes.find(name); found != kTypes.end())
        return found->second;
    throw InputError(
        "the header gives TYPE=" + *kind + " and PIXSIZE=" + *size +
        ", expected float of 32 or 64 bits, or signed or unsigned fixed of 8, 16, 32 or 64 bits");
}

std::endian byte_order(const Header& header, StoredType type)
{
    const std::string* cpu = header.find("CPU");
    if (cpu != nullptr && (*cpu == "decm" || *cpu == "alpha" || *cpu == "pc"))
        return std::endian::little;
    if (cpu != nullptr && (*cpu == "sun" || *cpu == "sgi"))
        return std::endian::big;
    if (byte_size(type) == 1)
        return std::endian::native;
    throw InputError("the header gives CPU=" + (cpu == nullptr ? "" : *cpu) +
                     ", expected decm, alpha, pc, sun or sgi");
}

//! Fixed-point samples are multiples of a power: SCALE=2**-8.
double scale(const Header& header)
{
    const std::string* text = header.find("SCALE");
    if (text == nullptr)
        return 1.0;
    std::istringstream stream(*text);
    double base = 0.0;
    double exponent = 0.0;
    char star1 = 0;
    char star2 = 0;
    const bool is_power =
        static_cast<bool>(stream >> base >> star1 >> star2 >> exponent) && star1 == '*' && star2 == '*';
    const double value = is_power ? std::pow(base, exponent) : 0.0;
    if (!std::isfinite(value) || value <= 0.0)
        throw InputError("the header gives SCALE=" + *text + ", expected a power like 2**0");
    return value;
}

StoredLattice lattice(const Header& header, const std::array<std::int64_t, 3>& size)
{
    StoredLattice lattice{.size = {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
        lattice.size[axis] = static_cast<std::size_t>(size[axis]);
    lattice.spacing = {number(header, "VX", 1.0), number(header, "VY", 1.0), number(header, "VZ", 1.0)};
    lattice.origin = {number(header, "TX", 0.0), number(header, "TY", 0.0), number(header, "TZ", 0.0)};
    return lattice;
}

bool is_rotated(const Header& header)
{
    return number(header, "RX", 0.0) != 0.0 || number(header, "RY", 0.0) != 0.0 ||
           number(header, "RZ", 0.0) != 0.0;
}

} // namespace

StoredVolume read_inrimage(const std::filesystem::path& path, const ReadOptions& options)
{
    const Header header = read_header(path);
    SampleEncoding encoding{.type = stored_type(header), .slope = scale(header)};
    encoding.order = byte_order(header, encoding.type);
    if (const std::int64_t values = dimension(header, "VDIM"); values != 1)
        throw InputError("has " + std::to_string(values) + " values in each sample (VDIM), expected one");
    const std::array<std::int64_t, 3> size{dimension(header, "XDIM"), dimension(header, "YDIM"),
                                           dimension(header, "ZDIM")};
    const std::size_t count = require_sane_size(size, byte_size(encoding.type));
    choose_frame(1, options.frame);
    const ByteSource source{.files = {path}, .offset = header.byte_count, .packing = Packing::kPlainOrGzip};
    require_bytes(source, count * byte_size(encoding.type));

    StoredVolume volume{.lattice = lattice(header, size), .format = "Inrimage"};
    volume.stored_type = stored_type_name(encoding.type);
    volume.has_spacing = header.find("VX") != nullptr;
    if (is_rotated(header))
        volume.warnings.emplace_back("the rotation RX, RY, RZ of the header is not applied");
    volume.samples = decode_samples(
        encoding, count, [&](std::span<std::byte> to) { read_bytes(source, to); }, volume.warnings);
    return volume;
}

} // namespace voroprobe
