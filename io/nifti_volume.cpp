// The format: nifti1.h of the NIfTI-1 data format, R. W. Cox et al., 2004.
//
// ITK decides where the samples are (sform, qform, units). The samples are read here, because ITK's reader
// fills what a truncated file lacks with zeros, replaces NaN by zero, and takes a size of 0 for 1.

#include <array>
#include <cmath>
#include <cstring>
#include <map>

#include <itkNiftiImageIO.h>

#include "io/volume_bytes.h"
#include "io/volume_formats.h"
#include "io/volume_itk.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

constexpr std::size_t kHeaderBytes = 348;

//! Offsets of the fields of the header.
constexpr std::size_t kDim = 40;
constexpr std::size_t kDatatype = 70;
constexpr std::size_t kPixdim = 76;
constexpr std::size_t kVoxOffset = 108;
constexpr std::size_t kSclSlope = 112;
constexpr std::size_t kSclInter = 116;
constexpr std::size_t kMagic = 344;

struct Header
{
    std::string bytes;
    std::endian order = std::endian::native;

    template <class Number>
    [[nodiscard]] Number at(std::size_t offset) const
    {
        std::array<char, sizeof(Number)> raw{};
        std::memcpy(raw.data(), bytes.data() + offset, sizeof(Number));
        if (order != std::endian::native)
            std::reverse(raw.begin(), raw.end());
        return std::bit_cast<Number>(raw);
    }
};

Header read_header(const std::filesystem::path& path)
{
    Header header{.bytes = read_head(path, kHeaderBytes)};
    if (header.bytes.size() < kHeaderBytes)
        throw InputError("truncated: has " + std::to_string(header.bytes.size()) +
                         " bytes, expected a NIfTI header of 348");
    constexpr auto kOther =
        std::endian::native == std::endian::little ? std::endian::big : std::endian::little;
    constexpr std::int32_t kNifti2HeaderBytes = 540;
    for (const std::endian order : {std::endian::native, kOther})
    {
        header.order = order;
        const auto announced = header.at<std::int32_t>(0);
        if (announced == kNifti2HeaderBytes)
            throw InputError("is a NIfTI-2 file, expected NIfTI-1");
        if (announced == kHeaderBytes && header.bytes.compare(kMagic, 4, std::string_view("n+1\0", 4)) == 0)
            return header;
    }
    throw InputError("is not a NIfTI file: expected a header of 348 bytes with the mark \"n+1\"");
}

StoredType stored_type(const Header& header)
{
    static const std::map<std::int16_t, StoredType> kTypes{
        {2, StoredType::kUint8},    {4, StoredType::kInt16},    {8, StoredType::kInt32},
        {16, StoredType::kFloat32}, {64, StoredType::kFloat64}, {256, StoredType::kInt8},
        {512, StoredType::kUint16}, {768, StoredType::kUint32}, {1024, StoredType::kInt64},
        {1280, StoredType::kUint64}};
    const auto code = header.at<std::int16_t>(kDatatype);
    if (const auto found = kTypes.find(code); found != kTypes.end())
        return found->second;
    throw InputError(
        "has samples of NIfTI type " + std::to_string(code) +
        " (color, complex or wider than 64 bits), expected one integer or floating-point number each");
}

//! Sizes along the three axes of space and, last, the number of volumes.
std::array<std::int64_t, 4> dimensions(const Header& header)
{
    const auto axes = static_cast<std::size_t>(header.at<std::int16_t>(kDim));
    if (axes < 1 || axes > 7)
        throw InputError("the header gives " + std::to_string(header.at<std::int16_t>(kDim)) +
                         " dimensions, expected 3 to 7");
    std::array<std::int64_t, 4> size{1, 1, 1, 1};
    for (std::size_t axis = 0; axis < axes; ++axis)
    {
        const std::int64_t n = header.at<std::int16_t>(kDim + 2 * (axis + 1));
        if (n < 1)
            throw InputError("the header gives the size " + std::to_string(n) + " along axis " +
                             std::to_string(axis) + ", expected at least 1");
        size[std::min<std::size_t>(axis, 3)] *= n;
    }
    return size;
}

SampleEncoding encoding(const Header& header)
{
    SampleEncoding encoding{.type = stored_type(header), .order = header.order};
    const double slope = header.at<float>(kSclSlope);
    const double intercept = header.at<float>(kSclInter);
    if (std::isfinite(slope) && std::isfinite(intercept) && slope != 0.0) // a slope of 0 means: not scaled
    {
        encoding.slope = slope;
        encoding.intercept = intercept;
    }
    return encoding;
}

bool gives_spacing(const Header& header)
{
    for (std::size_t axis = 1; axis <= 3; ++axis)
        if (header.at<float>(kPixdim + 4 * axis) != 0.0F)
            return true;
    return false;
}

//! Byte position of the first sample of a volume.
ByteSource frame_source(const std::filesystem::path& path, const Header& header, std::size_t frame_start)
{
    const double offset = header.at<float>(kVoxOffset);
    if (!(offset >= 0.0 && offset < 1e15))
        throw InputError("the header puts the samples at byte " + std::to_string(offset) +
                         ", expected 352 or more");
    constexpr std::uint64_t kFirstPossible = 352;
    return {.files = {path},
            .offset = std::max(kFirstPossible, static_cast<std::uint64_t>(offset)),
            .skip = frame_start,
            .packing = Packing::kPlainOrGzip};
}

} // namespace

StoredVolume read_nifti(const std::filesystem::path& path, const ReadOptions& options)
{
    const Header header = read_header(path);
    const SampleEncoding sample_encoding = encoding(header);
    const std::array<std::int64_t, 4> size = dimensions(header);
    const std::size_t count = require_sane_size(std::span(size).first(3), byte_size(sample_encoding.type));
    const std::size_t frame = choose_frame(static_cast<std::size_t>(size[3]), options.frame);
    const std::size_t frame_bytes = count * byte_size(sample_encoding.type);
    const ByteSource source = frame_source(path, header, frame * frame_bytes);
    require_bytes(source, frame_bytes);

    const auto image_io = itk::NiftiImageIO::New();
    read_itk_header(*image_io, path);
    StoredVolume volume{.lattice = itk_lattice(*image_io), .format = "NIfTI"};
    volume.stored_type = stored_type_name(sample_encoding.type);
    volume.has_spacing = gives_spacing(header);
    volume.samples =
        decode_samples(sample_encoding, count, [&](std::span<std::byte> to) { read_bytes(source, to); });
    return volume;
}

} // namespace voroprobe
