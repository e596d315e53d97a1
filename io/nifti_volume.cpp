// The format: nifti1.h of the NIfTI-1 data format, R. W. Cox et al., 2004.
//
// ITK decides where the samples are (sform, qform, units). The samples are read here, because ITK's reader
// fills what a truncated file lacks with zeros, replaces NaN by zero, and takes a size of 0 for 1.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>

#include <itkNiftiImageIO.h>

#include "io/volume_bytes.h"
#include "io/volume_formats.h"
#include "io/volume_itk.h"
#include "support/error.h"
#include "support/number_text.h"

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
constexpr std::size_t kXyztUnits = 123;
constexpr std::size_t kQformCode = 252;
constexpr std::size_t kSformCode = 254;
constexpr std::size_t kSrow = 280;
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

std::vector<std::string> scaling_warnings(const Header& header)
{
    const auto slope = header.at<float>(kSclSlope);
    const auto intercept = header.at<float>(kSclInter);
    if (std::isfinite(slope) && (std::isfinite(intercept) || slope == 0.0F))
        return {};
    return {"the header scales the samples by " + number_text(slope) + " and adds " + number_text(intercept) +
            ": ignored, they are taken as stored"};
}

//! False where the size of a voxel along an axis is 0, NaN or infinite.
bool gives_spacing(const Header& header)
{
    for (std::size_t axis = 1; axis <= 3; ++axis)
        if (const auto size = header.at<float>(kPixdim + 4 * axis); size == 0.0F || !std::isfinite(size))
            return false;
    return true;
}

double unit_in_mm(const Header& header)
{
    constexpr unsigned kSpaceUnits = 7;
    switch (static_cast<unsigned char>(header.bytes[kXyztUnits]) & kSpaceUnits)
    {
    case 1:
        return 1e3; // meter
    case 3:
        return 1e-3; // micron
    default:
        return 1.0;
    }
}

//! The lattice of the sform, turned from NIfTI's RAS to LPS.
StoredLattice sform_lattice(const Header& header, const std::array<std::int64_t, 4>& size)
{
    StoredLattice lattice{.size = {}};
    for (std::size_t row = 0; row < 3; ++row)
    {
        const double to_lps = unit_in_mm(header) * (row < 2 ? -1.0 : 1.0);
        for (std::size_t axis = 0; axis < 3; ++axis)
            lattice.direction.column[axis][row] = to_lps * header.at<float>(kSrow + 16 * row + 4 * axis);
        lattice.origin[row] = to_lps * header.at<float>(kSrow + 16 * row + 12);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        lattice.size[axis] = static_cast<std::size_t>(size[axis]);
        lattice.spacing[axis] = norm(lattice.direction.column[axis]);
        lattice.direction.column[axis] = normalized(lattice.direction.column[axis]);
    }
    return lattice;
}

//! The largest cosine of an angle between two axes.
double skew(const Matrix3& direction)
{
    const auto& [x, y, z] = direction.column;
    return std::max({std::abs(dot(x, y)), std::abs(dot(y, z)), std::abs(dot(z, x))});
}

//! Where ITK puts the samples: by the sform or, where that is sheared, by the qform. ITK gives up from a skew
//! of 1e-4 on where there is no qform; headers rounded to a few digits reach that, so we accept a little
//! more.
void read_lattice(const std::filesystem::path& path, const Header& header,
                  const std::array<std::int64_t, 4>& size, StoredVolume& volume)
{
    constexpr double kAlwaysAcceptedByItk = 5e-5;
    constexpr double kMaxSkew = 1e-3;
    const bool has_sform = header.at<std::int16_t>(kSformCode) > 0;
    const bool has_qform = header.at<std::int16_t>(kQformCode) > 0;
    const StoredLattice by_sform = sform_lattice(header, size);
    const double sform_skew = has_sform ? skew(by_sform.direction) : 0.0;
    if (sform_skew > kAlwaysAcceptedByItk && sform_skew <= kMaxSkew)
    {
        volume.lattice = by_sform;
        return;
    }
    if (sform_skew > kMaxSkew && !has_qform)
        throw InputError("the sform is sheared: two axes meet at a cosine of " + number_text(sform_skew) +
                         ", expected right angles (at most 0.001)");
    if (sform_skew > kMaxSkew)
        volume.warnings.emplace_back("the sform is sheared: the qform is used instead");
    const auto image_io = itk::NiftiImageIO::New();
    read_itk_header(*image_io, path);
    volume.lattice = itk_lattice(*image_io);
}

//! Byte position of the first sample of a volume.
ByteSource frame_source(const std::filesystem::path& path, const Header& header, std::size_t frame_start)
{
    const double offset = header.at<float>(kVoxOffset);
    if (!(offset >= 0.0 && offset < 1e15))
        throw InputError("the header puts the samples at byte " + number_text(offset) +
                         ", expected 352 to 1e+15");
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

    StoredVolume volume{.lattice = {.size = {}}, .format = "NIfTI", .warnings = scaling_warnings(header)};
    read_lattice(path, header, size, volume);
    volume.stored_type = stored_type_name(sample_encoding.type);
    volume.has_spacing = gives_spacing(header);
    volume.samples = decode_samples(
        sample_encoding, count, [&](std::span<std::byte> to) { read_bytes(source, to); }, volume.warnings);
    return volume;
}

} // namespace voroprobe
